// SPDX-License-Identifier: Apache-2.0
#include "dc/clock_registers.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "dc/start_time.h"
#include "dc/system_time_offset.h"

namespace syncline::dc {
namespace {

TEST(SystemTimeOffset, TakesA64BitClockToTheReferenceTime) {
  EXPECT_EQ(system_time_offset(820'000'000'000'000'000, 5'000'000'000, 0, true), 819'999'995'000'000'000U);
}

TEST(SystemTimeOffset, CountsTheLowWordOnlyFor32Bit) {
  EXPECT_EQ(system_time_offset(820'000'000'000'000'000, 705'032'704, 0, false), 2'714'504'704U);
}

TEST(SystemTimeOffset, AddsTheDelayBecauseTheSlaveLatchedLater) {
  // A slave 1200 ns behind, whose clock ran exactly like the reference's, latched 1200 ns later.
  EXPECT_EQ(system_time_offset(1'000'000, 1'001'200, 1'200, true), 0U);
}

TEST(SystemTimeOffset, BringsEveryLocalTimeToTheReferenceAtTheSameInstant) {
  EXPECT_TRUE(rc::check([](std::uint32_t reference, std::uint64_t local, std::uint16_t delay) {
    const auto wide = system_time_offset(reference, local, delay, true);
    RC_ASSERT(local + wide == std::uint64_t{reference} + delay);
    const auto narrow = system_time_offset(reference, local & 0xFFFF'FFFFU, delay, false);
    RC_ASSERT(narrow <= 0xFFFF'FFFFU);
    RC_ASSERT(static_cast<std::uint32_t>(local + narrow) == static_cast<std::uint32_t>(reference + delay));
  }));
}

TEST(StartTime, IsTheNextGridPointBehindTheSafetyPlusTheShift) {
  EXPECT_EQ(start_time({820'000'000'123'456'789, 5 * kMillisecond, kMillisecond, 0, 350 * kMicrosecond}),
            820'000'000'129'350'000);
}

TEST(StartTime, TakesAGridPointThatIsExactlyAtTheSafety) {
  EXPECT_EQ(start_time({10 * kMillisecond, 5 * kMillisecond, kMillisecond, 0, 0}), 15 * kMillisecond);
  EXPECT_EQ(start_time({10 * kMillisecond + 1, 5 * kMillisecond, kMillisecond, 0, 0}), 16 * kMillisecond);
}

TEST(StartTime, FollowsThePhaseOfTheBase) {
  EXPECT_EQ(start_time({10 * kMillisecond, 5 * kMillisecond, kMillisecond, 666'667, 0}), 15'666'667);
}

TEST(StartTime, ComesBeforeABaseThatIsStillToCome) { EXPECT_EQ(start_time({1'000, 0, 10'000, 23'000, 0}), 3'000); }

TEST(StartTime, LetsSlavesStartedAtDifferentTimesFireTogether) {
  EXPECT_TRUE(rc::check([] {
    const auto grid = *rc::gen::inRange<Nanoseconds>(31'250, 100 * kMillisecond);
    const auto base = *rc::gen::inRange<Nanoseconds>(0, grid);
    const auto now = *rc::gen::inRange<Nanoseconds>(0, 1'000 * kSecond);
    const auto safety = *rc::gen::inRange<Nanoseconds>(0, kSecond);
    const auto start = start_time({now, safety, grid, base, 0});
    RC_ASSERT(start >= now + safety);
    RC_ASSERT(start < now + safety + grid);
    RC_ASSERT((start - base) % grid == 0);
  }));
}

TEST(Extend32Bit, GoesToTheNearestTimeOnBothSidesOfAWrap) {
  const Nanoseconds wrap = Nanoseconds{1} << 32;
  EXPECT_EQ(extend_32bit(5, 3 * wrap - 10), 3 * wrap + 5);
  EXPECT_EQ(extend_32bit(0xFFFF'FFFBU, 3 * wrap + 5), 3 * wrap - 5);
}

TEST(Extend32Bit, RecoversEveryTimeWithinTwoSeconds) {
  EXPECT_TRUE(rc::check([] {
    const auto time = *rc::gen::inRange<Nanoseconds>(10 * kSecond, 800'000'000 * kSecond);
    const auto error = *rc::gen::inRange<Nanoseconds>(-2 * kSecond, 2 * kSecond);
    RC_ASSERT(extend_32bit(static_cast<std::uint32_t>(time), time + error) == time);
  }));
}

TEST(WrapToHalf, FoldsIntoHalfAPeriodToEachSide) {
  EXPECT_EQ(wrap_to_half(500, 1000), 500);
  EXPECT_EQ(wrap_to_half(501, 1000), -499);
  EXPECT_EQ(wrap_to_half(-500, 1000), 500);
  EXPECT_EQ(wrap_to_half(-499, 1000), -499);
  EXPECT_EQ(wrap_to_half(999'999'999'400, 1000), 400);
  EXPECT_EQ(wrap_to_half(2, 3), -1);
  EXPECT_EQ(wrap_to_half(1, 3), 1);
  EXPECT_EQ(wrap_to_half(-2, 3), 1);
}

TEST(WrapToHalf, KeepsThePhase) {
  EXPECT_TRUE(rc::check([] {
    const auto period = *rc::gen::inRange<Nanoseconds>(1, 100 * kMillisecond);
    const auto value = *rc::gen::inRange<Nanoseconds>(-1'000 * kSecond, 1'000 * kSecond);
    const auto folded = wrap_to_half(value, period);
    RC_ASSERT((value - folded) % period == 0);
    RC_ASSERT(2 * folded <= period);
    RC_ASSERT(2 * folded > -period);
  }));
}

}  // namespace
}  // namespace syncline::dc
