// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/sync_judge.h"

#include <gtest/gtest.h>

#include "config/dcm_settings.h"

namespace syncline::dc {
namespace {

class SyncJudgeTest : public ::testing::Test {
 protected:
  void SetUp() override { restart(); }
  void restart() {
    judge = SyncJudge(settings);
    judge.start(kStart);
  }
  void run(int from_ms, int to_ms, Nanoseconds error) {
    for (int ms = from_ms; ms < to_ms; ++ms) judge.observe(kStart + ms * kMillisecond, error);
  }
  void silence(int from_ms, int to_ms) {
    for (int ms = from_ms; ms < to_ms; ++ms) judge.observe_silence(kStart + ms * kMillisecond);
  }
  static constexpr Nanoseconds kStart = 100 * kSecond;
  DcmSettings settings{};
  SyncJudge judge{settings};
};

TEST_F(SyncJudgeTest, InSyncWhenTheErrorStaysWithinTheLimitForTheSettleTime) {
  run(0, 100, 5'000);
  run(100, 1600, -4'000);
  EXPECT_FALSE(judge.in_sync());
  run(1600, 1601, 4'000);
  EXPECT_TRUE(judge.in_sync());
  EXPECT_EQ(judge.in_sync_after(), 1600 * kMillisecond);
}

TEST_F(SyncJudgeTest, AViolationBeforeTheLockStartsTheSettleTimeAgain) {
  run(0, 1400, 0);
  run(1400, 1401, 4'001);
  run(1401, 2901, 0);
  EXPECT_FALSE(judge.in_sync());
  run(2901, 2902, 0);
  EXPECT_TRUE(judge.in_sync());
}

TEST_F(SyncJudgeTest, TheStartDelayIsNotJudged) {
  settings.start_delay_ms = 500;
  restart();
  run(0, 2000, 0);
  EXPECT_FALSE(judge.in_sync());
  run(2000, 2001, 0);
  EXPECT_TRUE(judge.in_sync());
  EXPECT_EQ(judge.in_sync_after(), 2000 * kMillisecond);
}

TEST_F(SyncJudgeTest, AShortViolationIsNoLossAndALongOneIs) {
  run(0, 2000, 0);
  run(2000, 2199, 9'000);
  EXPECT_TRUE(judge.in_sync());
  run(2199, 2200, 0);  // the patience begins anew
  run(2200, 2400, 9'000);
  EXPECT_TRUE(judge.in_sync());
  run(2400, 2401, 9'000);
  EXPECT_FALSE(judge.in_sync());
  EXPECT_TRUE(judge.was_in_sync());
}

TEST_F(SyncJudgeTest, WhatIsKnownToBeLostHasNoPatience) {
  run(0, 2000, 0);
  judge.lose();
  EXPECT_FALSE(judge.in_sync());
  run(2000, 3500, 0);
  EXPECT_FALSE(judge.in_sync());
  run(3500, 3501, 0);
  EXPECT_TRUE(judge.in_sync());
}

TEST_F(SyncJudgeTest, KeepsTheFirstTimeInSyncWhenItComesBack) {
  run(0, 2000, 0);
  run(2000, 2300, 9'000);
  ASSERT_FALSE(judge.in_sync());
  run(2300, 3800, 0);
  EXPECT_FALSE(judge.in_sync());
  run(3800, 3801, 0);
  EXPECT_TRUE(judge.in_sync());
  EXPECT_EQ(judge.in_sync_after(), 1500 * kMillisecond);
}

TEST_F(SyncJudgeTest, SilenceThatLastsIsALoss) {
  run(0, 2000, 0);
  silence(2000, 2200);
  EXPECT_TRUE(judge.in_sync());
  silence(2200, 2202);
  EXPECT_FALSE(judge.in_sync());
}

/// Of what was not heard nobody knows that it was beyond the limit; of what comes afterwards he does.
TEST_F(SyncJudgeTest, ALossBySilenceIsTheSilencesUntilSomethingIsBeyondTheLimit) {
  silence(0, 1000);
  EXPECT_FALSE(judge.lost_by_silence()) << "there was nothing to lose";
  run(1000, 3000, 0);
  silence(3000, 3300);
  EXPECT_TRUE(judge.lost_by_silence());
  run(3300, 3400, 0);
  silence(3400, 3700);
  EXPECT_TRUE(judge.lost_by_silence());
  run(3700, 3701, 9'000);
  EXPECT_FALSE(judge.lost_by_silence());
  silence(3701, 4000);
  EXPECT_FALSE(judge.lost_by_silence()) << "it was lost already";
  run(4000, 6000, 0);
  ASSERT_TRUE(judge.in_sync());
  run(6000, 6300, 9'000);
  EXPECT_FALSE(judge.in_sync() || judge.lost_by_silence());
}

TEST_F(SyncJudgeTest, ALostFrameDoesNotStartTheSettleTimeAgain) {
  run(0, 700, 0);
  silence(700, 703);
  run(703, 1501, 0);
  EXPECT_TRUE(judge.in_sync());
}

TEST_F(SyncJudgeTest, SilenceBeforeTheLockIsNoAgreement) {
  run(0, 10, 0);
  silence(10, 3000);
  run(3000, 3001, 0);
  EXPECT_FALSE(judge.in_sync());
}

}  // namespace
}  // namespace syncline::dc
