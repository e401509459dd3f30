// SPDX-License-Identifier: Apache-2.0
#include "trace/held_frames.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

constexpr Nanoseconds kLate = 100 * kMicrosecond;

TEST(HeldFrames, AreSummedOverTheTimeThatIsAskedFor) {
  HeldFrames held;
  EXPECT_EQ(held.sum(0, kSecond), 0);
  for (int i = 0; i < 10; ++i) held.note(kSecond + i * kMillisecond, kLate);
  held.note(2 * kSecond, 2 * kLate);
  held.note(2 * kSecond + kMillisecond, HeldFrames::kRemarkable - 1);
  EXPECT_EQ(held.sum(kSecond, 3 * kSecond), 12 * kLate);
  EXPECT_EQ(held.sum(kSecond + HeldFrames::kSpan, 2 * kSecond - 1), 5 * kLate) << "the second span of five";
  EXPECT_EQ(held.sum(2 * kSecond + 1, 3 * kSecond), 0);
}

TEST(HeldFrames, OfALongTimeTheLatestAreKept) {
  HeldFrames held;
  for (int i = 0; i < 10'000; ++i) held.note(i * kMillisecond, kLate);
  EXPECT_EQ(held.sum(9'600 * kMillisecond, 10 * kSecond), 400 * kLate);
  EXPECT_EQ(held.sum(0, 9 * kSecond), 0);
}

/// A stamp that is wrong says so of its frame alone.
TEST(HeldFrames, SmallOnesCountInARow) {
  constexpr Nanoseconds kTail = 60 * kMicrosecond;
  HeldFrames held;
  for (int i = 0; i < 30; ++i) held.note(kSecond + i * kMillisecond, i % 3 == 0 ? 0 : kTail);
  EXPECT_EQ(held.sum(0, 2 * kSecond), 0);
  held.note(2 * kSecond, 0);
  for (int i = 0; i < 4; ++i) held.note(3 * kSecond + i * kMillisecond, kTail);
  EXPECT_EQ(held.sum(2 * kSecond, 4 * kSecond), 4 * kTail) << "the first ones of the row, too";
}

}  // namespace
}  // namespace syncline
