// SPDX-License-Identifier: Apache-2.0
#include "compile/dcm_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compile/compile.h"
#include "protocol/dcm_error.h"
#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

NetworkConfig network(DcmMode mode = DcmMode::kBusShift) {
  auto project = sample::small_machine();
  project.master.dc.dcm.mode = mode;
  return compile(project)->config;
}

TEST(DcmCheck, FindsNothingInAMachineOfAnyMode) {
  for (const auto mode : {DcmMode::kOff, DcmMode::kBusShift, DcmMode::kMasterShift, DcmMode::kMasterRefClock,
                          DcmMode::kLinkLayerRefClock, DcmMode::kMasterShiftByApp}) {
    const auto config = network(mode);
    EXPECT_THAT(dcm_problems(config), IsEmpty()) << dcm_mode_name(mode);
    EXPECT_EQ(bus_shift_configured(config), steers_reference_clock(mode)) << dcm_mode_name(mode);
    EXPECT_TRUE(check_dcm(config));
  }
}

TEST(DcmCheck, ASetValueBelowFrameTimeAndDelayIsRefusedWithTheLimit) {
  auto config = network();
  const auto least = least_set_value(config, 0);
  EXPECT_GT(least, 6'720);  // one smallest frame
  config.dc.dcm.set_value = least - 1;
  const auto status = check_dcm(config);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().subject, "master.dc.set_value_us");
  EXPECT_EQ(status.error().received, 0x981201C9);
  EXPECT_THAT(status.error().detail.text(),
              HasSubstr(exact_time_text(least - 1) + " is outside " + exact_time_text(least) + "..999.999 us"));
  config.dc.dcm.set_value = least;
  EXPECT_TRUE(check_dcm(config));
  EXPECT_EQ(dcm_problems(config, 1).size(), 1U) << "the way to the last slave counts";
}

TEST(DcmCheck, ASyncCycleThatDoesNotFitTheBusCycleIsNamedWithItsSlave) {
  auto config = network();
  std::size_t drive = 0;
  while (!config.slaves[drive].dc || config.slaves[drive].dc->cycle_time0 == 0) ++drive;
  config.slaves[drive].dc->assign_activate = 0x0300;
  for (const Nanoseconds fits : {250'000, 500'000, 1'000'000, 3'000'000}) {
    config.slaves[drive].dc->cycle_time0 = fits;
    EXPECT_THAT(dcm_problems(config), IsEmpty()) << fits;
  }
  config.slaves[drive].dc->cycle_time0 = 1'300'000;
  const auto problems = dcm_problems(config);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].code, 0x981201C8);
  EXPECT_THAT(facts_text(problems[0].finding), HasSubstr(config.slaves[drive].name));
  EXPECT_THAT(facts_text(problems[0].finding), HasSubstr("1.3 ms"));
}

TEST(DcmCheck, AnExternalClockNeedsABridge) {
  const auto status = check_dcm(network(DcmMode::kDcx));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().received, 0x981201CC);
  EXPECT_THAT(status.error().detail.text(), HasSubstr("0x10F4"));
}

TEST(DcmCheck, AModeThatSteersNeedsItsCyclicCommand) {
  auto config = network(DcmMode::kMasterShift);
  config.dc.dcm.mode = DcmMode::kMasterRefClock;
  const auto status = check_dcm(config);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().subject, "master.dc.mode");
  EXPECT_THAT(status.error().detail.text(), HasSubstr("master-ref-clock"));
  config.dc.enabled = false;
  EXPECT_TRUE(check_dcm(config));
}

TEST(DcmCheck, StandardLoopValuesAreLeftAlone) {
  const auto writes = [](bool standard) {
    auto project = sample::small_machine();
    project.master.dc.dcm.standard_loop_values = standard;
    const auto config = compile(project)->config;
    return std::ranges::count_if(config.master.init_cmds,
                                 [](const InitCmd& c) { return c.ado >= 0x0930 && c.ado <= 0x0935; });
  };
  EXPECT_EQ(writes(false), 2);
  EXPECT_EQ(writes(true), 0);
}

TEST(DcmCheck, EachOfTheFourteenCodesHasANameAndWords) {
  std::set<std::string_view> names;
  for (std::uint32_t code = 0x981201C0; code <= 0x981201CD; ++code) {
    EXPECT_FALSE(dc::dcm_error_text(code).empty()) << code;
    names.insert(dc::dcm_error_name(code));
  }
  EXPECT_EQ(names.size(), 14U);
  EXPECT_EQ(dc::dcm_error_name(0x981201CA), "DCM_E_DRIFT_TO_HIGH");
  EXPECT_EQ(dc::dcm_error_name(0x981201CC), "DCX_E_NO_EXT_CLOCK");
  EXPECT_TRUE(dc::dcm_error_name(0x981201CE).empty() && dc::dcm_error_text(0).empty());
}

}  // namespace
}  // namespace syncline
