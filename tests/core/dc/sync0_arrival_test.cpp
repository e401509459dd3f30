// SPDX-License-Identifier: Apache-2.0
#include "dc/sync0_arrival.h"

#include <gtest/gtest.h>

namespace syncline::dc {
namespace {

void expect(const Sync0Arrival& is, std::int64_t number, Nanoseconds phase, Nanoseconds margin) {
  EXPECT_EQ(is.number, number);
  EXPECT_EQ(is.phase, phase);
  EXPECT_EQ(is.margin, margin);
}

TEST(Sync0Arrival, HasItsPeriodThePhaseInItAndTheDistanceToTheNextSync0) {
  const Sync0Grid grid{.first = 1'000, .period = 400};
  expect(sync0_arrival(grid, 1'000), 0, 0, 0);
  expect(sync0_arrival(grid, 1'001), 0, 1, 399);
  expect(sync0_arrival(grid, 1'399), 0, 399, 1);
  expect(sync0_arrival(grid, 1'400), 1, 0, 0);
  expect(sync0_arrival(grid, 999), -1, 399, 1);
  expect(sync0_arrival(grid, 600), -1, 0, 0);
  expect(sync0_arrival(grid, 599), -2, 399, 1);
}

/// SYNC0 every second cycle: the phase tells the cycle, which the phase in the bus cycle does not.
TEST(Sync0Arrival, FollowsSystemTimeWhereSync0IsSlowerThanTheBus) {
  const Sync0Grid grid{.first = 40'000, .period = 2 * kMillisecond};
  const auto arrived = outputs_arrival(700 * kMillisecond + 10'000, 500, 25'000);
  expect(sync0_arrival(grid, arrived), 349, 1'995'500, 4'500);
  expect(sync0_arrival(grid, arrived + kMillisecond), 350, 995'500, 1'004'500);
}

TEST(Sync0Arrival, FindsTheNextOneWhereSync0IsFasterThanTheBus) {
  const Sync0Grid grid{.first = 0, .period = 125'000};
  expect(sync0_arrival(grid, outputs_arrival(3 * kMillisecond, 1'000, 130'000)), 25, 6'000, 119'000);
}

/// Decades of nanoseconds leave nothing to be rounded.
TEST(Sync0Arrival, IsExactInFullSystemTime) {
  const Nanoseconds now = 850'000'000LL * kSecond;
  expect(sync0_arrival({.first = 7, .period = kMillisecond}, now + 9), 850'000'000'000LL, 2, 999'998);
}

}  // namespace
}  // namespace syncline::dc
