// SPDX-License-Identifier: Apache-2.0
#include "trace/sample_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>

#include "trace/csv.h"
#include "trace/histogram.h"
#include "trace/statistics.h"

namespace syncline {
namespace {

CycleSample sample(std::uint64_t cycle) {
  CycleSample s;
  s.cycle = cycle;
  s.send_time = static_cast<Nanoseconds>(cycle) * kMillisecond;
  s.flags = CycleSample::kDeviationValid | CycleSample::kDcmActive | CycleSample::kReferenceValid;
  s.deviation_ored_ns = 12;
  s.dcm_error_ns = -34;
  return s;
}

std::vector<float> values(const MinMaxSeries& series) {
  std::vector<float> all;
  series.for_each(INT64_MIN, INT64_MAX, [&all](Nanoseconds, float value) { all.push_back(value); });
  return all;
}

TEST(SampleStore, LostFramesAndInvalidValuesAreGaps) {
  SampleStore store(2);
  auto lost = sample(2);
  lost.flags |= CycleSample::kFrameLost;
  auto unmonitored = sample(3);
  unmonitored.flags = 0;
  store.append(std::vector<CycleSample>{sample(1), lost, unmonitored});
  const auto ored = values(store.series(SampleStore::Series::kDeviationOred));
  ASSERT_EQ(ored.size(), 3U);
  EXPECT_EQ(ored[0], 12);
  EXPECT_TRUE(std::isnan(ored[1]));
  EXPECT_TRUE(std::isnan(ored[2]));
  EXPECT_TRUE(std::isnan(values(store.series(SampleStore::Series::kDcmError))[2]));
}

TEST(SampleStore, MissingCyclesLeaveAGap) {
  SampleStore store(0);
  store.append(std::vector<CycleSample>{sample(1), sample(5)});
  EXPECT_EQ(store.missing_cycles(), 3U);
  const auto ored = values(store.series(SampleStore::Series::kDeviationOred));
  ASSERT_EQ(ored.size(), 3U);
  EXPECT_TRUE(std::isnan(ored[1]));
}

TEST(SampleStore, SlaveReadingsGoToTheirSlave) {
  SampleStore store(3);
  auto s = sample(1);
  s.slave_position = 2;
  s.slave_deviation_ns = -7;
  s.sm2_position = 1;
  s.slave_sm2_missed = 4;
  auto foreign = sample(2);
  foreign.slave_position = 9;  // of another configuration: ignored
  store.append(std::vector<CycleSample>{s, foreign});
  EXPECT_EQ(store.slave_deviation(2).at(INT64_MAX - 1)->value, -7);
  EXPECT_TRUE(store.slave_deviation(0).empty());
  EXPECT_EQ(store.slave_sm2_missed(1).at(INT64_MAX - 1)->value, 4);
}

TEST(SampleCsv, HasAsManyFieldsAsTheHeaderAndNoDecimalComma) {
  const auto* previous = std::setlocale(LC_ALL, "de_DE.UTF-8");
  auto s = sample(1);
  s.drift_ppm = 1.5F;
  std::string text;
  append_sample_csv(text, std::vector<CycleSample>{s});
  if (previous != nullptr) std::setlocale(LC_ALL, "C");
  const auto commas = [](const std::string& t) { return std::count(t.begin(), t.end(), ','); };
  EXPECT_EQ(commas(text), commas(sample_csv_header()));
  EXPECT_THAT(text, testing::HasSubstr(",1.5,"));
}

TEST(Statistics, MatchesTheDefinitions) {
  Statistics statistics;
  for (const double value : {3.0, -4.0, 1.0, 4.0}) statistics.add(value);
  EXPECT_DOUBLE_EQ(statistics.mean(), 1.0);
  EXPECT_DOUBLE_EQ(statistics.rms(), std::sqrt((9.0 + 16 + 1 + 16) / 4));
  EXPECT_EQ(statistics.min(), -4.0);
  EXPECT_EQ(statistics.max_magnitude(), 4.0);
}

TEST(Histogram, PercentilesAreWithinABinAndTheMaximumIsExact) {
  Histogram histogram;
  for (std::int64_t value = 1; value <= 100'000; ++value) histogram.add(value);
  EXPECT_EQ(histogram.max(), 100'000);
  EXPECT_EQ(histogram.percentile(1.0), 100'000);
  EXPECT_NEAR(static_cast<double>(histogram.percentile(0.5)), 50'000, 50'000 / 32.0);
  EXPECT_NEAR(static_cast<double>(histogram.percentile(0.999)), 99'900, 100'000 / 32.0);
  std::uint64_t total = 0;
  for (const auto& bin : histogram.bins()) {
    EXPECT_LT(bin.low, bin.high);
    total += bin.count;
  }
  EXPECT_EQ(total, histogram.count());
}

}  // namespace
}  // namespace syncline
