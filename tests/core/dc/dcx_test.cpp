// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcx.h"

#include <gtest/gtest.h>

#include <cmath>

#include "config/dcm_settings.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

/// Host and reference clock run at the same rate, the external clock is ahead; cycle by cycle without noise.
class Bridged {
 public:
  explicit Bridged(bool control_off = false)
      : settings_{.mode = DcmMode::kDcx, .set_value = {}, .control_off = control_off},
        dcx_(settings_, kMillisecond, 400'000) {
    dcx_.start(0, now_ + 600'000, now_);
  }
  /// One cycle; `ahead`: of the external clock, nothing when the bridge does not tell.
  DcmAction cycle(std::optional<Nanoseconds> ahead, bool expected = true) {
    written = dcx_.reference_write(now_, now_);
    DcmObservation seen{now_, now_, now_ + 600'000};
    seen.external_difference = ahead;
    seen.external_expected = expected;
    const auto action = dcx_.observe(seen);
    now_ += kMillisecond;
    return action;
  }
  void cycles(int count, std::optional<Nanoseconds> ahead, bool expected = true) {
    for (int i = 0; i < count; ++i) (void)cycle(ahead, expected);
  }
  /// What is written, beyond what the reference clock would show by itself.
  Nanoseconds push(Nanoseconds ahead) {
    (void)cycle(ahead);
    (void)cycle(ahead);
    return written.value_or(-1) - (now_ - kMillisecond + 600'000);
  }
  void set_led_by_substitute(bool substitute) { dcx_.set_led_by_substitute(substitute); }
  [[nodiscard]] const DcmState& state() const { return dcx_.state(); }

  std::optional<Nanoseconds> written;

 private:
  DcmSettings settings_;
  Dcx dcx_;
  Nanoseconds now_ = 10 * kSecond;
};

TEST(Dcx, WritesNothingBeforeTheExternalClockIsKnown) {
  Bridged bridge;
  bridge.cycles(10, std::nullopt);
  EXPECT_FALSE(bridge.written);
  bridge.cycles(2, 0);
  EXPECT_TRUE(bridge.written);
  bridge.cycles(2, std::nullopt);
  EXPECT_FALSE(bridge.written) << "it is gone again";
}

TEST(Dcx, WritesNothingWithTheControlOff) {
  Bridged bridge(true);
  bridge.cycles(10, 5'000);
  EXPECT_FALSE(bridge.written);
  EXPECT_EQ(bridge.state().external_error, -5'000) << "it looks on";
}

/// A fifth of the way a cycle, at most 600 ns, towards the external clock; 2 ns more a cycle, so that slaves follow.
TEST(Dcx, PushesTheReferenceClockTowardsTheExternalOne) {
  EXPECT_EQ(Bridged().push(0), 0);
  for (const int sign : {1, -1}) {
    Bridged bridge;
    EXPECT_NEAR(static_cast<double>(sign * bridge.push(sign * 100'000)), 2, 3);
    bridge.cycles(98, sign * 100'000);
    EXPECT_NEAR(static_cast<double>(sign * bridge.push(sign * 100'000)), 200, 5);
    bridge.cycles(300, sign * 100'000);
    EXPECT_NEAR(static_cast<double>(sign * bridge.push(sign * 100'000)), 600, 1);
    bridge.cycles(300, sign * 1'000);
    EXPECT_NEAR(static_cast<double>(sign * bridge.push(sign * 1'000)), 200 + 120, 5) << "what has stayed is learned";
  }
}

/// What stays is learned: 1 us behind for a second is 0.4 us more.
TEST(Dcx, LearnsWhatStays) {
  Bridged bridge;
  bridge.cycles(1'000, 1'000);
  EXPECT_NEAR(static_cast<double>(bridge.push(1'000)), 200 + 400, 4);
  Bridged far;
  far.cycles(1'000, 100'000);
  far.cycles(400, 0);
  EXPECT_NEAR(static_cast<double>(far.push(0)), 0, 1) << "a way to go is no rate";
}

/// By an eighth, because it learns quickly; and what one clock needed to keep its place the next one need not.
TEST(Dcx, PushesASubstituteLessAndForgetsWhatTheOtherClockNeeded) {
  Bridged bridge;
  bridge.cycles(1'000, 1'000);
  bridge.set_led_by_substitute(false);
  EXPECT_NEAR(static_cast<double>(bridge.push(1'000)), 200 + 400, 4) << "the same clock is back";
  bridge.set_led_by_substitute(true);
  bridge.cycles(100, 1'000);
  EXPECT_NEAR(static_cast<double>(bridge.push(1'000)), 200 / 8 + 40, 4);
  bridge.set_led_by_substitute(false);
  bridge.cycles(150, 1'000);
  EXPECT_NEAR(static_cast<double>(bridge.push(1'000)), 200 + 60, 4);
}

/// Only the phase in the cycle counts: half a cycle is the most.
TEST(Dcx, TellsTheErrorWithinHalfACycle) {
  Bridged bridge;
  (void)bridge.cycle(300);
  EXPECT_EQ(bridge.state().external_error, -300);
  (void)bridge.cycle(5 * kMillisecond - 700);
  EXPECT_EQ(bridge.state().external_error, 700);
  (void)bridge.cycle(std::nullopt);
  EXPECT_EQ(bridge.state().external_error, std::nullopt);
}

TEST(Dcx, IsInSyncWhereBothClocksAre) {
  Bridged bridge;
  bridge.cycles(2'000, 100);
  EXPECT_TRUE(bridge.state().in_sync);
  EXPECT_EQ(bridge.state().error_code, 0U);
  (void)bridge.cycle(4'000);
  EXPECT_TRUE(bridge.state().in_sync) << "the limit itself";
  EXPECT_EQ(bridge.state().external, SyncObstacle::kNone);
  (void)bridge.cycle(-4'001);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kExternalClock) << "too far away";
  bridge.cycles(500, 0);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kExternalClock) << "which may only come by";
  bridge.cycles(2, 0);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kNone);
}

/// Readings at the limit are one loss, also where some are missing.
TEST(Dcx, IsBackOnlyWhenItHasStayed) {
  Bridged bridge;
  bridge.cycles(2'000, 100);
  (void)bridge.cycle(4'100);
  for (int i = 0; i < 2'000; ++i) {
    (void)bridge.cycle(i % 7 == 0 ? std::nullopt : std::optional<Nanoseconds>(i % 100 == 1 ? 4'100 : 3'900));
    ASSERT_EQ(bridge.state().external, SyncObstacle::kExternalClock) << i;
  }
  bridge.cycles(502, 3'900);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kNone);
}

/// On the way to it for the first time, and again when nobody has told it for a while.
TEST(Dcx, TellsTheWayToTheExternalClockFromOneThatLeft) {
  Bridged bridge;
  (void)bridge.cycle(5'000);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kToExternalClock);
  (void)bridge.cycle(3'000);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kToExternalClock) << "which may only come by";
  bridge.cycles(501, 3'000);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kNone);
  bridge.cycles(3, std::nullopt);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kNone);
  (void)bridge.cycle(5'000);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kExternalClock) << "it was gone for some cycles only";
  bridge.cycles(2'000, std::nullopt);
  (void)bridge.cycle(5'000);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kToExternalClock);
  bridge.cycles(2, std::nullopt, false);
  bridge.cycles(502, 3'000);
  (void)bridge.cycle(5'000);
  EXPECT_EQ(bridge.state().external, SyncObstacle::kExternalClock);
}

/// What comes nearer by 8 us a second is not pushed any more, and what comes faster is held back.
TEST(Dcx, GoesNoFasterThanSlavesFollow) {
  Bridged bridge;
  Nanoseconds ahead = 300'000;
  for (int i = 0; i < 1'000; ++i) (void)bridge.cycle(ahead -= 8);
  EXPECT_NEAR(static_cast<double>(bridge.push(ahead - 8)), 0, 20);
  for (int i = 0; i < 1'000; ++i) (void)bridge.cycle(ahead -= 20);
  EXPECT_NEAR(static_cast<double>(bridge.push(ahead - 20)), -600, 1);
}

TEST(Dcx, HasNotMetAClockThatComesBy) {
  Bridged bridge;
  for (Nanoseconds ahead = -30'000; ahead < 30'000; ahead += 30) {
    (void)bridge.cycle(ahead);
    ASSERT_EQ(bridge.state().external, SyncObstacle::kToExternalClock) << ahead;
  }
}

/// A step of the external clock is a new distance, and no speed.
TEST(Dcx, TakesAStepForNoRate) {
  Bridged bridge;
  bridge.cycles(1'000, 1'000);
  bridge.cycles(400, 101'000);
  EXPECT_NEAR(static_cast<double>(bridge.push(101'000)), 600 + 400, 10);
}

/// A second of patience, from the first cycle without it.
TEST(Dcx, SaysThatTheExternalClockIsMissing) {
  Bridged bridge;
  bridge.cycles(2'000, 0);
  bridge.cycles(1'000, std::nullopt);
  EXPECT_EQ(bridge.state().error_code, 0U);
  EXPECT_TRUE(bridge.state().in_sync);
  (void)bridge.cycle(std::nullopt);
  EXPECT_EQ(bridge.state().error_code, kDcxErrorNoExternalClock);
  EXPECT_FALSE(bridge.state().in_sync);
  (void)bridge.cycle(0);
  EXPECT_EQ(bridge.state().error_code, 0U);
  bridge.cycles(3'000, std::nullopt, false);
  EXPECT_EQ(bridge.state().error_code, 0U) << "nobody expects it";
}

}  // namespace
}  // namespace syncline::dc
