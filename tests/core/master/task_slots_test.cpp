// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/task_slots.h"

#include <gtest/gtest.h>

#include <vector>

namespace syncline {
namespace {

constexpr Nanoseconds kCycle = kMillisecond;

TEST(TaskSlots, CountTheCyclesThatWereLeftOut) {
  TaskSlots slots(kCycle);
  EXPECT_EQ(slots.next(0, {}), 0);
  EXPECT_EQ(slots.next(0, {}), 1);
  EXPECT_EQ(slots.next(3, {}), 5);
}

TEST(TaskSlots, FollowTheGridOnceThereIsOne) {
  TaskSlots slots(kCycle);
  EXPECT_EQ(slots.next(0, {}), 0);
  EXPECT_EQ(slots.next(0, 1'000 * kCycle + 300), 1'000);
  EXPECT_EQ(slots.next(0, 1'001 * kCycle - 300), 1'001);
  EXPECT_EQ(slots.next(2, 1'004 * kCycle), 1'004);
  EXPECT_EQ(slots.next(0, -7 * kCycle - 1), -7) << "a grid that begins later";
}

/// Frames that nobody keeps in their place slide through the grid.
TEST(TaskSlots, ChangeOnceWhileFramesSlideThroughTheGrid) {
  TaskSlots slots(kCycle);
  EXPECT_EQ(slots.next(0, 100 * kCycle), 100);
  int changes = 0;
  std::int64_t before = 100;
  for (int i = 1; i <= 4'000; ++i) {
    // A quarter of a microsecond a cycle, and what is read of it varies by one.
    const auto number = slots.next(0, 100 * kCycle + i * (kCycle + 250) + (i % 2 == 0 ? 1'000 : -1'000));
    if (number != before + 1) ++changes;
    before = number;
  }
  EXPECT_EQ(changes, 1) << "a cycle in all";
}

std::vector<std::int64_t> taken(TaskTurn& turn, const std::vector<std::int64_t>& slots) {
  std::vector<std::int64_t> taken;
  for (const auto slot : slots) {
    if (turn.take(slot)) taken.push_back(slot);
  }
  return taken;
}

TEST(TaskTurn, IsTakenAtMultiplesAndBehindOneThatWasLeftOut) {
  TaskTurn third(3), each(1);
  EXPECT_EQ(taken(third, {1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 16}), (std::vector<std::int64_t>{1, 3, 6, 10, 12, 16}));
  EXPECT_EQ(taken(third, {-4, -3, -2, -1, 0}), (std::vector<std::int64_t>{-4, -3, 0}));
  EXPECT_EQ(taken(each, {1, 2, 2, 1}), (std::vector<std::int64_t>{1, 2, 2, 1})) << "the base task goes with every one";
}

}  // namespace
}  // namespace syncline
