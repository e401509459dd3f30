// SPDX-License-Identifier: Apache-2.0
#include "trace/dcm_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/cycle_sample.h"
#include "trace/csv.h"
#include "trace/signals.h"

namespace syncline {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

CycleSample logged(std::uint64_t cycle) {
  CycleSample s;
  s.cycle = cycle;
  s.send_time = 820'000'000'000'000'000 + static_cast<Nanoseconds>(cycle) * kMillisecond;
  s.reference_time = 820'000'000'000'333'340 + static_cast<Nanoseconds>(cycle) * kMillisecond;
  s.dcm_error_ns = -250;
  s.dcm_error_filtered_ns = -200;
  s.drift_ppm = 12.5F;
  s.dcm_adjust_ns = 7;
  s.dcm_output_sum_ns = -12.25F;
  s.dcm_output_total_ns = -1'000'000;
  s.dcm_error_code = 0x981201C2;
  s.deviation_ored_ns = 31;
  s.flags = CycleSample::kReferenceValid | CycleSample::kDcmActive | CycleSample::kDeviationValid;
  s.master_sync = SyncState::kInSync;
  return s;
}

TEST(DcmLog, HasTheColumnsOfTheManualInItsOrder) {
  EXPECT_EQ(
      dcm_log_header(),
      "Time[ms];SyncSetVal [ns];BusTime [ns];BusTimeOff;CtlAdj [ns];CtlErr [ns];CtlErrFilt;Drift [ppm];"
      "CtlErr [1/10 pmil];CtlOutSum;CtlOutTot;DCStartTime;DCMErrorCode;DCMInSync;DCInSync;SystemTimeDifference [ns]\n");
}

TEST(DcmLog, SaysTheCycleInTheUnitsAndWithTheSignsOfTheManual) {
  DcmLog log(666'667, kMillisecond);
  ASSERT_TRUE(log.row(logged(10)));
  log.set_start_time(820'000'000'005'000'000);
  const auto row = log.row(logged(12));
  ASSERT_TRUE(row);
  std::string text;
  append_dcm_log(text, *row);
  EXPECT_EQ(text,
            "2.000;666667;820000000012333340;333340;7;250;200;-12.500;2.500;-12.250;-1000000;820000000005000000;"
            "0x981201c2;1;0;31\n");
}

TEST(DcmLog, HasNoLineForACycleWithoutAReading) {
  DcmLog log(666'667, kMillisecond);
  auto lost = logged(1);
  lost.flags &= static_cast<std::uint16_t>(~CycleSample::kReferenceValid);
  EXPECT_FALSE(log.row(lost));
  auto unmonitored = logged(2);
  unmonitored.flags &= static_cast<std::uint16_t>(~CycleSample::kDeviationValid);
  EXPECT_FALSE(log.row(unmonitored)->system_time_difference_ns);
}

TEST(DcmLog, IsReadBackAsItWasWritten) {
  DcmLog log(666'667, kMillisecond);
  std::string text = dcm_log_header();
  std::vector<DcmLogRow> rows;
  for (std::uint64_t cycle = 0; cycle < 50; ++cycle) {
    auto s = logged(cycle);
    if (cycle % 3 == 0) s.flags &= static_cast<std::uint16_t>(~CycleSample::kDeviationValid);
    rows.push_back(*log.row(s));
    append_dcm_log(text, rows.back());
  }
  const auto read = read_dcm_log(text);
  ASSERT_TRUE(read) << read.error().detail.text();
  EXPECT_EQ(*read, rows);
}

TEST(DcmLog, OtherSeparatorsOrdersAndColumnsAreRead) {
  const auto read = read_dcm_log("drift[ppm],Something,CtlErr [ns]\r\n-1.5,x,300\r\n\r\n2,y,-4\r\n");
  ASSERT_TRUE(read) << read.error().detail.text();
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ((*read)[0].drift_ppm, -1.5);
  EXPECT_EQ((*read)[1].error_ns, -4);
  EXPECT_TRUE(read_dcm_log("Time[ms]\tCtlErr [ns]\n1\t2\n"));
}

TEST(DcmLog, WhatIsNoLogIsRefusedWithItsLine) {
  EXPECT_FALSE(read_dcm_log(""));
  EXPECT_FALSE(read_dcm_log("a;b\n1;2\n"));
  const auto bad = read_dcm_log("Time[ms];CtlErr [ns]\n1;2\n2;three\n");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().line, 3);
  EXPECT_THAT(bad.error().detail.text(), HasSubstr("three"));
  for (const char* huge : {"1e300", "-1e300", "99999999999999999999"}) {
    EXPECT_TRUE(read_dcm_log(std::string("CtlErr [ns]\n") + huge + "\n")) << huge;
  }
  EXPECT_FALSE(read_dcm_log("CtlErr [ns]\nnan\n"));
}

TEST(ClockDifferences, AreInTheSampleTableUnderTheirNames) {
  EXPECT_THAT(sample_csv_header(), HasSubstr(",NetworkToSubDeviceClkDiff_ns,MdeviceToNetworkClkDiff_ns,"));
  const auto s = logged(1);
  std::string text;
  append_sample_csv(text, std::span(&s, 1));
  EXPECT_THAT(text, HasSubstr(",31,-250,"));
  text.clear();
  const CycleSample without_clocks;
  append_sample_csv(text, std::span(&without_clocks, 1));
  EXPECT_THAT(text, HasSubstr(",0,0,0,,0,,,,,\n"));
  auto unheard = logged(1);  // a controller runs, but the reference clock did not answer in this cycle
  unheard.flags = CycleSample::kDcmActive;
  EXPECT_FALSE(info(Signal::kMasterToNetwork).of_cycle(unheard));
}

}  // namespace
}  // namespace syncline
