// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/spin_budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace syncline {
namespace {

constexpr Nanoseconds kMost = 50 * kMicrosecond;

void wake(SpinBudget& budget, int count, double scale, std::uint64_t seed = 1) {
  Random random(seed);
  for (int i = 0; i < count; ++i) budget.observe(1 + static_cast<Nanoseconds>(std::abs(random.normal()) * scale));
}

TEST(SpinBudget, BeginsWithAllThatIsAllowedAndEndsWithWhatTheHostNeeds) {
  SpinBudget budget(kMost);
  EXPECT_EQ(budget.amount(), kMost);
  wake(budget, 5'000, 2'000);
  EXPECT_GT(budget.amount(), 5'000);
  EXPECT_LT(budget.amount(), 8'000);
  EXPECT_NEAR(static_cast<double>(budget.wake_p50()), 1'350, 300);
  EXPECT_LT(budget.mean_spent(), 8'000);
}

TEST(SpinBudget, NeverSpendsMoreThanTheUserAllows) {
  SpinBudget budget(kMost);
  wake(budget, 5'000, 200'000);
  EXPECT_LE(budget.amount(), kMost);
  EXPECT_GT(budget.amount(), kMost * 8 / 10);
  SpinBudget none(0);
  wake(none, 5'000, 2'000);
  EXPECT_EQ(none.amount(), 0);
  EXPECT_GT(none.wake_p99(), 4'000) << "what it would need is known all the same";
  EXPECT_EQ(none.mean_spent(), 0);
}

TEST(SpinBudget, SpendsNothingForWhatIsTolerated) {
  SpinBudget quiet(kMost, 20 * kMicrosecond);
  wake(quiet, 5'000, 2'000);
  EXPECT_EQ(quiet.amount(), 0);
  EXPECT_GT(quiet.wake_p99(), 4'000);
  SpinBudget busy(kMost, 20 * kMicrosecond);
  wake(busy, 5'000, 15'000);
  // 99 of 100 wake up at most 39 us late: they are woken earlier by what is more than 20 us.
  EXPECT_GT(busy.amount(), 17'000);
  EXPECT_LT(busy.amount(), 25'000);
  EXPECT_LT(busy.mean_spent(), 14'000);
  EXPECT_EQ(SpinBudget::tolerated(kMillisecond), 50 * kMicrosecond);
}

TEST(SpinBudget, SpendsNothingOnWhatItCannotCatch) {
  SpinBudget stalled(kMost, 50 * kMicrosecond);
  for (int i = 0; i < 5'000; ++i) stalled.observe(i % 40 == 0 ? 2 * kMillisecond : 18 * kMicrosecond);
  EXPECT_EQ(stalled.amount(), 0) << "one in 40 is late by milliseconds, all others are in time without";
  EXPECT_GT(stalled.wake_p99(), kMillisecond) << "and this is told";
}

TEST(SpinBudget, FollowsAHostThatBecomesWorse) {
  SpinBudget budget(kMost);
  wake(budget, 5'000, 1'000);
  const auto before = budget.amount();
  wake(budget, 1'000, 8'000);
  EXPECT_GT(budget.amount(), 3 * before);
}

TEST(SpinBudget, CyclesWithoutSleepSayNothing) {
  SpinBudget budget(kMost);
  for (int i = 0; i < 1'000; ++i) budget.observe(0);
  EXPECT_EQ(budget.amount(), kMost);
}

TEST(SpinBudget, AnyLatenessFindsABin) {
  SpinBudget budget(kSecond);
  for (Nanoseconds late = 1; late < 100 * kSecond; late = late * 3 + 1) budget.observe(late);
  for (int i = 0; i < 1'000; ++i) budget.observe(INT64_MAX / 4);
  EXPECT_EQ(budget.amount(), 0) << "none of these would be caught";
}

}  // namespace
}  // namespace syncline
