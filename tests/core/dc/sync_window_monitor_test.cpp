// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_window_monitor.h"

#include <gtest/gtest.h>

namespace syncline::dc {
namespace {

using State = SyncWindowMonitor::State;
using Edge = SyncWindowMonitor::Edge;

constexpr Nanoseconds kStart = 820'000'000 * kSecond;

class SyncWindowMonitorTest : public ::testing::Test {
 protected:
  /// Readings every millisecond in [from, to) ms; the last edge that was told.
  Edge run(int from_ms, int to_ms, std::uint32_t magnitude) {
    Edge last = Edge::kNone;
    for (int ms = from_ms; ms < to_ms; ++ms) {
      const auto edge = monitor.observe(kStart + ms * kMillisecond, magnitude);
      if (edge != Edge::kNone) last = edge;
    }
    return last;
  }
  SyncWindowSettings settings{true, 7, 1500};
  SyncWindowMonitor monitor{settings, true, kStart};
};

TEST_F(SyncWindowMonitorTest, LimitIsAPowerOfTwoLessOne) { EXPECT_EQ(monitor.limit_ns(), 127U); }

TEST_F(SyncWindowMonitorTest, InSyncAfterTheWholeSettleTime) {
  EXPECT_EQ(run(0, 100, 5000), Edge::kNone);
  EXPECT_EQ(run(100, 1600, 127), Edge::kNone);
  EXPECT_EQ(monitor.state(), State::kSettling);
  EXPECT_EQ(run(1600, 1601, 127), Edge::kInSync);
  EXPECT_EQ(monitor.state(), State::kInSync);
  EXPECT_EQ(monitor.settled_after(), 100 * kMillisecond);
}

TEST_F(SyncWindowMonitorTest, OneReadingBeyondTheLimitStartsTheSettleTimeAgain) {
  run(0, 1400, 10);
  run(1400, 1401, 128);
  EXPECT_EQ(run(1401, 2901, 10), Edge::kNone);
  EXPECT_EQ(run(2901, 2902, 10), Edge::kInSync);
  EXPECT_EQ(monitor.settled_after(), 1401 * kMillisecond);
}

TEST_F(SyncWindowMonitorTest, OutOfSyncAtOnceAndToldOnce) {
  run(0, 2000, 10);
  EXPECT_EQ(run(2000, 2001, 128), Edge::kOutOfSync);
  EXPECT_EQ(monitor.state(), State::kOutOfSync);
  EXPECT_EQ(run(2001, 2100, 128), Edge::kNone);
}

TEST_F(SyncWindowMonitorTest, ComesBackAfterAnotherSettleTime) {
  run(0, 2000, 10);
  run(2000, 2100, 4000);
  EXPECT_EQ(run(2100, 3600, 0), Edge::kNone);
  EXPECT_EQ(run(3600, 3601, 0), Edge::kInSync);
  EXPECT_EQ(monitor.settled_after(), 2100 * kMillisecond);
}

TEST_F(SyncWindowMonitorTest, NothingIsSaidWhereNothingIsMonitored) {
  monitor = SyncWindowMonitor(settings, false, kStart);
  EXPECT_EQ(run(0, 5000, 1'000'000), Edge::kNone);
  EXPECT_EQ(run(5000, 9000, 0), Edge::kNone);
  EXPECT_EQ(monitor.state(), State::kNotMonitored);
}

TEST_F(SyncWindowMonitorTest, WithoutSettleTimeTheFirstGoodReadingIsEnough) {
  settings.settle_time_ms = 0;
  monitor = SyncWindowMonitor(settings, true, kStart);
  EXPECT_EQ(run(0, 1, 127), Edge::kInSync);
}

}  // namespace
}  // namespace syncline::dc
