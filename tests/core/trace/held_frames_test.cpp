// SPDX-License-Identifier: Apache-2.0
#include "trace/held_frames.h"

#include <gtest/gtest.h>

namespace syncline {
namespace {

TEST(HeldFrames, AreSummedOverTheTimeThatIsAskedFor) {
  HeldFrames held;
  EXPECT_EQ(held.sum(0, kSecond), 0);
  for (int i = 0; i < 10; ++i) held.note(kSecond + i * kMillisecond, 30 * kMicrosecond);
  held.note(2 * kSecond, 100 * kMicrosecond);
  held.note(2 * kSecond + kMillisecond, HeldFrames::kRemarkable - 1);
  EXPECT_EQ(held.sum(kSecond, 3 * kSecond), 400 * kMicrosecond);
  EXPECT_EQ(held.sum(kSecond + HeldFrames::kSpan, 2 * kSecond - 1), 150 * kMicrosecond) << "the second span of five";
  EXPECT_EQ(held.sum(2 * kSecond + 1, 3 * kSecond), 0);
}

TEST(HeldFrames, OfALongTimeTheLatestAreKept) {
  HeldFrames held;
  for (int i = 0; i < 10'000; ++i) held.note(i * kMillisecond, 20 * kMicrosecond);
  EXPECT_EQ(held.sum(9'600 * kMillisecond, 10 * kSecond), 400 * 20 * kMicrosecond);
  EXPECT_EQ(held.sum(0, 9 * kSecond), 0);
}

}  // namespace
}  // namespace syncline
