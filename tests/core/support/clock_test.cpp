// SPDX-License-Identifier: Apache-2.0
#include "support/clock.h"

#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <vector>

#include "support/jitter_profile.h"

namespace syncline {
namespace {

std::vector<Nanoseconds> wakeups(const JitterProfile& profile, std::uint64_t seed, int count) {
  VirtualClock clock(0);
  clock.set_wakeup_jitter(profile, seed);
  std::vector<Nanoseconds> late;
  for (int i = 1; i <= count; ++i) {
    clock.sleep_until(i * kMillisecond);
    late.push_back(clock.now() - i * kMillisecond);
  }
  return late;
}

TEST(RealClock, CountsFromTheDcEpochAndRises) {
  RealClock clock;
  const auto first = clock.now();
  const auto unix_now = static_cast<std::int64_t>(::time(nullptr));
  EXPECT_NEAR(static_cast<double>(first / kSecond), static_cast<double>(unix_now - kDcEpochUnixSeconds), 2.0);
  EXPECT_GE(clock.now(), first);
  EXPECT_FALSE(clock.is_virtual());
}

TEST(RealClock, SleepReturnsNotBeforeTheDeadlineAndAtOnceWhenItHasPassed) {
  RealClock clock;
  const auto deadline = clock.now() + 100 * kMicrosecond;
  clock.sleep_until(deadline);
  EXPECT_GE(clock.now(), deadline);
  clock.sleep_until(clock.now() - kSecond);
  clock.sleep_until(0);  // before this machine was started
}

TEST(VirtualClock, TimePassesOnlyBySleepingAndNeverBack) {
  VirtualClock clock;
  EXPECT_TRUE(clock.is_virtual());
  EXPECT_EQ(clock.now(), VirtualClock::kDefaultStart);
  clock.sleep_until(clock.now() + 5);
  EXPECT_EQ(clock.now(), VirtualClock::kDefaultStart + 5);
  clock.sleep_until(clock.now() - 1);
  clock.advance_to(0);
  EXPECT_EQ(clock.now(), VirtualClock::kDefaultStart + 5);
}

TEST(VirtualClock, WakeupsAreLateAndTheSameForTheSameSeed) {
  const auto first = wakeups(JitterProfile::desktop(), 7, 2'000);
  EXPECT_EQ(first, wakeups(JitterProfile::desktop(), 7, 2'000));
  EXPECT_NE(first, wakeups(JitterProfile::desktop(), 8, 2'000));
  EXPECT_GE(*std::min_element(first.begin(), first.end()), 0);
  EXPECT_GT(*std::max_element(first.begin(), first.end()), 3'000);
}

TEST(VirtualClock, WakeUpsAreLateAsTheProfileSays) {
  JitterProfile profile;
  profile.wake_up = {{{0, 100}, {0.5, 1'000}, {0.99, 3'000}, {1, 100'000}}};
  auto late = wakeups(profile, 11, 50'000);
  std::ranges::sort(late);
  EXPECT_GE(late.front(), 100);
  EXPECT_LE(late.back(), 100'000);
  EXPECT_NEAR(static_cast<double>(late[25'000]), 1'000, 30);
  EXPECT_NEAR(static_cast<double>(late[49'000]), 2'960, 30);
  EXPECT_NEAR(static_cast<double>(late[49'750]), 51'500, 10'000);
}

TEST(VirtualClock, StallsComeByChanceAndTheSameForTheSameSeed) {
  JitterProfile profile;
  profile.stalls_per_second = 2;
  profile.stall = {{{0, 2e6}, {1, 4e6}}};
  const auto stalled = [&](std::uint64_t seed) {
    std::vector<Nanoseconds> late;
    VirtualClock clock(0);
    clock.set_wakeup_jitter(profile, seed);
    for (int i = 1; i <= 500'000; ++i) {
      const auto due = i * 200 * kMicrosecond;
      clock.sleep_until(due);
      if (clock.now() > due && (late.empty() || late.back() < due)) late.push_back(clock.now());
    }
    return late;
  };
  const auto first = stalled(3);
  EXPECT_NEAR(static_cast<double>(first.size()), 200, 45);  // in 100 s
  EXPECT_EQ(first, stalled(3));
  EXPECT_NE(first, stalled(4));
}

TEST(QuantileCurve, IsLinearBetweenItsPointsAndFlatOutside) {
  const QuantileCurve curve({{0.1, 10}, {0.5, 50}, {0.5, 60}, {0.9, 100}});
  EXPECT_DOUBLE_EQ(curve.at(0), 10);
  EXPECT_DOUBLE_EQ(curve.at(0.3), 30);
  EXPECT_DOUBLE_EQ(curve.at(0.7), 80);
  EXPECT_DOUBLE_EQ(curve.at(1), 100);
  EXPECT_DOUBLE_EQ(QuantileCurve().at(0.5), 0);
}

TEST(VirtualClock, FramesInFlightHaveNoJitter) {
  VirtualClock clock(0);
  clock.set_wakeup_jitter(JitterProfile::bad(), 1);
  clock.advance_to(123'456);
  EXPECT_EQ(clock.now(), 123'456);
}

TEST(VirtualClock, WhoIsDueInAStandstillGoesOnAtItsEnd) {
  VirtualClock clock(0);
  clock.add_standstill(50 * kMillisecond, 20 * kMillisecond);
  clock.add_standstill(10 * kMillisecond, 5 * kMillisecond);
  clock.add_standstill(60 * kMillisecond, 30 * kMillisecond);  // goes on where the first ends
  clock.sleep_until(9 * kMillisecond);
  EXPECT_EQ(clock.now(), 9 * kMillisecond);
  clock.sleep_until(11 * kMillisecond);
  EXPECT_EQ(clock.now(), 15 * kMillisecond);
  clock.advance_to(16 * kMillisecond);
  EXPECT_EQ(clock.now(), 16 * kMillisecond);
  clock.advance_to(50 * kMillisecond);
  EXPECT_EQ(clock.now(), 90 * kMillisecond);
  clock.sleep_until(91 * kMillisecond);
  EXPECT_EQ(clock.now(), 91 * kMillisecond);
}

TEST(VirtualClock, AStandstillThatIsSleptThroughIsNotNoticed) {
  VirtualClock clock(0);
  clock.add_standstill(10 * kMillisecond, 5 * kMillisecond);
  clock.sleep_until(20 * kMillisecond);
  EXPECT_EQ(clock.now(), 20 * kMillisecond);
}

}  // namespace
}  // namespace syncline
