// SPDX-License-Identifier: Apache-2.0
#include "dc/master_verdict.h"

#include <gtest/gtest.h>

#include "channels/values/sync_obstacle_text.h"

namespace syncline::dc {
namespace {

constexpr Nanoseconds kStart = 820'000'000 * kSecond;

/// A controller whose schedule is in sync, in a cycle of 1 ms.
class MasterVerdictTest : public ::testing::Test {
 protected:
  void run(int from_ms, int to_ms, MasterVerdict::Input input) {
    for (int ms = from_ms; ms < to_ms; ++ms) {
      input.time = kStart + ms * kMillisecond;
      verdict.observe(input);
    }
  }
  MasterVerdict::Input good{.led = true, .read = true, .schedule_in_sync = true, .frame_error = 3'000};
  MasterVerdict verdict{{.settle = 1500 * kMillisecond, .stale = 50 * kMillisecond, .late_allowed = 600'000}, kStart};
};

TEST_F(MasterVerdictTest, FollowsTheControllerWhenNothingElseIsInTheWay) {
  auto input = good;
  input.schedule_in_sync = false;
  run(0, 100, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kControlError);
  run(100, 101, good);
  EXPECT_TRUE(verdict.in_sync());
}

TEST_F(MasterVerdictTest, AStepOfTheReferenceClockIsTheCauseOfWhatFollows) {
  run(0, 100, good);
  auto input = good;
  input.clock_stepped = true;
  input.schedule_in_sync = false;
  input.error_code = 0x981201C2;
  run(100, 101, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kClockStep);
  input.clock_stepped = false;
  run(101, 1599, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kClockStep);
  run(1600, 1601, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kErrorCode);
}

TEST_F(MasterVerdictTest, NeverBesideAnErrorCode) {
  auto input = good;
  input.error_code = 0x981201CA;
  run(0, 100, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kErrorCode);
  EXPECT_TRUE(verdict.schedule_in_sync());
}

TEST_F(MasterVerdictTest, NeverWithinTheSettleTimeOfACycleLeftOut) {
  run(0, 100, good);
  auto input = good;
  input.skipped_cycles = 3;
  run(100, 101, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kCyclesLeftOut);
  run(101, 1600, good);
  EXPECT_FALSE(verdict.in_sync());
  run(1600, 1601, good);
  EXPECT_TRUE(verdict.in_sync());
}

TEST_F(MasterVerdictTest, NeverWithinTheSettleTimeOfAFrameThatMetSync0) {
  run(0, 100, good);
  auto input = good;
  input.frame_error = 600'000;
  run(100, 101, input);
  EXPECT_TRUE(verdict.in_sync());
  input.frame_error = 600'001;
  run(101, 102, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kLateFrames);
  EXPECT_TRUE(verdict.schedule_in_sync());  // nobody has to wait for the host to get better
}

TEST_F(MasterVerdictTest, NeverOnOldReadings) {
  run(0, 100, good);
  auto input = good;
  input.read = false;
  run(100, 149, input);
  EXPECT_TRUE(verdict.in_sync());
  run(149, 151, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kNoReading);
  EXPECT_FALSE(verdict.schedule_in_sync());
  run(151, 152, good);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kSettling);
  run(152, 1652, good);
  EXPECT_TRUE(verdict.in_sync());
}

TEST_F(MasterVerdictTest, NeverWithoutAReferenceClockNorSoonAfterAnotherOneLeads) {
  run(0, 100, good);
  auto input = good;
  input.led = false;
  run(100, 101, input);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kNoReferenceClock);
  verdict.distrust(kStart + 101 * kMillisecond);
  run(101, 1600, good);
  EXPECT_EQ(verdict.obstacle(), SyncObstacle::kSettling);
  run(1600, 1602, good);
  EXPECT_TRUE(verdict.in_sync());
}

TEST(SyncObstacle, HasWords) {
  for (auto i = static_cast<int>(SyncObstacle::kNoReferenceClock); i <= static_cast<int>(SyncObstacle::kSettling);
       ++i) {
    EXPECT_FALSE(obstacle_text(static_cast<SyncObstacle>(i)).empty()) << i;
  }
  EXPECT_TRUE(obstacle_text(SyncObstacle::kNone).empty());
}

}  // namespace
}  // namespace syncline::dc
