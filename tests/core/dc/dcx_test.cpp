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

/// A fifth of the way a cycle, at most 600 ns, towards the external clock.
TEST(Dcx, PushesTheReferenceClockTowardsTheExternalOne) {
  EXPECT_EQ(Bridged().push(0), 0);
  EXPECT_NEAR(static_cast<double>(Bridged().push(1'000)), 200, 1);
  EXPECT_NEAR(static_cast<double>(Bridged().push(-1'000)), -200, 1);
  EXPECT_NEAR(static_cast<double>(Bridged().push(100'000)), 600, 1);
  EXPECT_NEAR(static_cast<double>(Bridged().push(-100'000)), -600, 1);
}

/// What stays is learned: 1 us behind for a second is 0.4 us more.
TEST(Dcx, LearnsWhatStays) {
  Bridged bridge;
  bridge.cycles(1'000, 1'000);
  EXPECT_NEAR(static_cast<double>(bridge.push(1'000)), 200 + 400, 4);
  Bridged far;
  far.cycles(1'000, 100'000);
  EXPECT_NEAR(static_cast<double>(far.push(0)), 0, 1) << "a way to go is no rate";
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
  (void)bridge.cycle(-4'001);
  EXPECT_FALSE(bridge.state().in_sync) << "the external clock is too far away";
  (void)bridge.cycle(0);
  EXPECT_TRUE(bridge.state().in_sync);
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
