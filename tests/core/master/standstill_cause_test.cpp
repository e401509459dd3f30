// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/standstill_cause.h"

#include <gtest/gtest.h>

#include "support/clock.h"

namespace syncline {
namespace {

/// Time stands; only what others took of the processor is told.
class WaitingClock final : public Clock {
 public:
  [[nodiscard]] Nanoseconds now() const override { return 0; }
  using Clock::sleep_until;
  void sleep_until(Nanoseconds) override {}
  [[nodiscard]] std::optional<Nanoseconds> processor_wait() override { return waited; }
  [[nodiscard]] bool is_virtual() const override { return true; }
  std::optional<Nanoseconds> waited = 5 * kMillisecond;
};

TEST(StandstillCause, SaysHowMuchOfItOthersTook) {
  WaitingClock clock;
  StandstillCause cause(clock);
  cause.before_wait();
  clock.waited = 8 * kMillisecond;
  cause.note(4 * kMillisecond);
  EXPECT_EQ(cause.held(), 4 * kMillisecond);
  EXPECT_EQ(cause.held_by_others(), 3 * kMillisecond);
}

TEST(StandstillCause, ATimerThatCameLateIsNobodys) {
  WaitingClock clock;
  StandstillCause cause(clock);
  cause.before_wait();
  *clock.waited += 20 * kMicrosecond;
  cause.note(3 * kMillisecond);
  cause.before_wait();
  cause.note(2 * kMillisecond);
  EXPECT_EQ(cause.held(), 5 * kMillisecond);
  EXPECT_EQ(cause.held_by_others(), 20 * kMicrosecond);
}

TEST(StandstillCause, WhatOthersTookInTheCyclesBeforeIsNotMoreThanTheStandstill) {
  WaitingClock clock;
  StandstillCause cause(clock);
  cause.before_wait();
  *clock.waited += 50 * kMillisecond;
  cause.note(1 * kMillisecond);
  EXPECT_EQ(cause.held_by_others(), 1 * kMillisecond);
}

TEST(StandstillCause, IsUnknownOnAClockThatDoesNotSay) {
  WaitingClock clock;
  clock.waited = std::nullopt;
  StandstillCause cause(clock);
  cause.before_wait();
  cause.note(1 * kMillisecond);
  EXPECT_EQ(cause.held(), 1 * kMillisecond);
  EXPECT_EQ(cause.held_by_others(), std::nullopt);
}

}  // namespace
}  // namespace syncline
