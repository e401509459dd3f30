// SPDX-License-Identifier: Apache-2.0
#include "trace/sample_store.h"

#include <gtest/gtest.h>

#include <cmath>

namespace syncline {
namespace {

CycleSample stored(std::uint64_t cycle) {
  CycleSample s;
  s.cycle = cycle;
  s.send_time = static_cast<Nanoseconds>(cycle) * kMillisecond;
  s.flags = CycleSample::kFollowersRead | CycleSample::kDcmActive | CycleSample::kReferenceValid;
  s.deviation_ns = 12;
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
  auto lost = stored(2);
  lost.flags |= CycleSample::kFrameLost;
  auto unmonitored = stored(3);
  unmonitored.flags = 0;
  store.append(std::vector<CycleSample>{stored(1), lost, unmonitored});
  const auto ored = values(store.series(SampleStore::Series::kDeviation));
  ASSERT_EQ(ored.size(), 3U);
  EXPECT_EQ(ored[0], 12);
  EXPECT_TRUE(std::isnan(ored[1]));
  EXPECT_TRUE(std::isnan(ored[2]));
  EXPECT_TRUE(std::isnan(values(store.series(SampleStore::Series::kDcmError))[2]));
}

TEST(SampleStore, MissingCyclesLeaveAGap) {
  SampleStore store(0);
  store.append(std::vector<CycleSample>{stored(1), stored(5)});
  EXPECT_EQ(store.missing_cycles(), 3U);
  const auto ored = values(store.series(SampleStore::Series::kDeviation));
  ASSERT_EQ(ored.size(), 3U);
  EXPECT_TRUE(std::isnan(ored[1]));
}

TEST(SampleStore, SlaveReadingsGoToTheirSlave) {
  SampleStore store(3);
  auto s = stored(1);
  s.flags |= CycleSample::kSlaveFollows;
  s.slave_position = 2;
  s.slave_deviation_ns = -7;
  s.sm2_position = 1;
  s.slave_sm2_missed = 4;
  auto foreign = stored(2);
  foreign.flags |= CycleSample::kSlaveFollows;
  foreign.slave_position = 9;  // of another configuration: ignored
  auto leader = stored(3);
  leader.slave_position = 0;  // follows nobody: what it shows is no deviation
  leader.slave_deviation_ns = 30'000;
  store.append(std::vector<CycleSample>{s, foreign, leader});
  EXPECT_EQ(store.slave_deviation(2).at(INT64_MAX - 1)->value, -7);
  EXPECT_TRUE(store.slave_deviation(0).empty());
  EXPECT_EQ(store.slave_sm2_missed(1).at(INT64_MAX - 1)->value, 4);
}

}  // namespace
}  // namespace syncline
