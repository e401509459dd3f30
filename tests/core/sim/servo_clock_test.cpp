// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/servo_clock.h"

#include <gtest/gtest.h>

namespace syncline::sim {
namespace {

constexpr Nanoseconds kPeriod = 125'000, kBegin = 10 * kSecond;

/// After so many SYNC0s of which the first one is `ahead` ns in front of the timer's period.
ServoClock followed(Nanoseconds ahead, int count, Nanoseconds grid, double ppm = 0) {
  ServoClock clock(kPeriod, ppm, 0);
  const auto first = clock.take_before(kBegin + 1);
  auto sync0 = *first + kPeriod - ahead;
  for (int i = 0; i < count; ++i, sync0 += 8 * kPeriod) {
    clock.keep_last(1, sync0 + kPeriod / 2);
    while (clock.take_before(sync0 + kPeriod / 2)) {
    }
    clock.follow(sync0, grid);
  }
  return clock;
}

/// The nearer of the two periods about a SYNC0 is meant, half a period counts as late.
TEST(SimServoClock, ThePhaseErrorIsTheWayToTheNearestPeriod) {
  for (const Nanoseconds ahead : {0L, 1L, 40'000L, 62'500L}) {
    EXPECT_EQ(followed(ahead, 1, kPeriod).phase_error(), ahead) << ahead;
  }
  for (const Nanoseconds ahead : {62'501L, 100'000L, 124'999L}) {
    EXPECT_EQ(followed(ahead, 1, kPeriod).phase_error(), ahead - kPeriod) << ahead;
  }
  EXPECT_EQ(followed(-62'500, 1, kPeriod).phase_error(), 62'500);
  EXPECT_EQ(followed(-62'499, 1, kPeriod).phase_error(), -62'499);
}

/// Also where nobody has taken the periods that have passed since.
TEST(SimServoClock, ThePhaseErrorIsThatOfTheNearestPeriodHoweverOldTheNextOneIs) {
  const auto error = [](Nanoseconds late) {
    ServoClock clock(kPeriod, 0, 0);
    const auto first = clock.take_before(kBegin + 1);
    clock.follow(*first + kPeriod + late, kPeriod);
    return clock.phase_error();
  };
  EXPECT_EQ(error(0), 0);
  EXPECT_EQ(error(62'499), -62'499);
  EXPECT_EQ(error(62'500), 62'500);
  EXPECT_EQ(error(80'000), 45'000);
  EXPECT_EQ(error(3 * kPeriod + 80'000), 45'000);
}

/// A SYNC0 cycle that is a multiple of a part of the period is aligned to that part.
TEST(SimServoClock, APartOfThePeriodIsAlignedToWhereTheCycleIsItsMultiple) {
  EXPECT_EQ(followed(70'000, 1, kPeriod / 2).phase_error(), 7'500);
  EXPECT_EQ(followed(40'000, 1, kPeriod / 2).phase_error(), -22'500);
}

TEST(SimServoClock, LocksFromEitherSideBehindSixteenGoodOnes) {
  for (const Nanoseconds ahead : {-50'000L, -2'000L, 2'000L, 50'000L}) {
    const auto clock = followed(ahead, 400, kPeriod, 40);
    EXPECT_TRUE(clock.locked()) << ahead;
    EXPECT_LT(std::abs(clock.phase_error()), 50) << ahead;
  }
  EXPECT_FALSE(followed(0, 15, kPeriod).locked());
  EXPECT_TRUE(followed(0, 16, kPeriod).locked());
  EXPECT_FALSE(followed(30'000, 16, kPeriod).locked());
}

TEST(SimServoClock, ARestartTellsHowFarTheTimerWasOff) {
  ServoClock clock(kPeriod, 0, 0);
  const auto tick = *clock.take_before(kBegin + 1);
  clock.restart(tick + kPeriod - 30'000);
  EXPECT_EQ(clock.phase_error(), 30'000);
  EXPECT_EQ(clock.take_before(tick + kPeriod), tick + kPeriod - 30'000);
  clock.restart(tick + kPeriod);
  EXPECT_EQ(clock.phase_error(), -30'000);
  EXPECT_TRUE(clock.locked());
  clock.release();
  EXPECT_FALSE(clock.locked());
}

}  // namespace
}  // namespace syncline::sim
