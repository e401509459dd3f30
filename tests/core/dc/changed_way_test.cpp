// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/changed_way.h"

#include <gtest/gtest.h>

#include <array>

namespace syncline::dc {
namespace {

constexpr Nanoseconds kLeast = 1'000;

TEST(ChangedWayOffset, IsTheMedianOfTheReadingsBehindTheChange) {
  ChangedWay way(kMillisecond, kLeast);
  EXPECT_FALSE(way.take(-11'000)) << "nobody has come or gone: it is the clock";
  EXPECT_EQ(way.offset(), 0);
  way.note();
  // One stamp in eight is wrong by tens of microseconds.
  EXPECT_TRUE(way.take(-11'300));
  EXPECT_EQ(way.offset(), -11'300) << "at once: the clock must not run after it";
  for (const Nanoseconds off : {30'000, -11'600, -11'400, -11'900, -11'000, -11'500, -11'450})
    EXPECT_FALSE(way.take(off));
  EXPECT_EQ(way.offset(), -11'450);
}

TEST(ChangedWayOffset, IsLedBackByTwoPpm) {
  for (const auto cycle : {250 * kMicrosecond, kMillisecond, 4 * kMillisecond}) {
    ChangedWay way(cycle, kLeast);
    way.note();
    for (int i = 0; i < 8; ++i) (void)way.take(11'000);
    const auto per_cycle = 2e-6 * static_cast<double>(std::min(cycle, kMillisecond));
    for (int i = 0; i < 1'000; ++i) (void)way.take(11'000 - way.offset());
    EXPECT_NEAR(static_cast<double>(way.offset()), 11'000 - 1'000 * per_cycle, 1);
    for (int i = 0; i < 30'000; ++i) (void)way.take(0);
    EXPECT_EQ(way.offset(), 0);
  }
}

TEST(ChangedWayOffset, IsNoneWhereReadingsAreWhereTheyWereOrFarAway) {
  ChangedWay way(kMillisecond, kLeast);
  for (const Nanoseconds off : {Nanoseconds{900}, Nanoseconds{-1'000}, Nanoseconds{50'001}, -kMillisecond / 2}) {
    way.note();
    for (int i = 0; i < 8; ++i) EXPECT_FALSE(way.take(off));
    EXPECT_EQ(way.offset(), 0) << off;
  }
  way.note();
  EXPECT_TRUE(way.take(50'000));
  EXPECT_EQ(way.offset(), 50'000);
}

/// The rest of a branch, and what comes back.
TEST(ChangedWayOffset, OfSecondChangesCountsFromTheFirst) {
  ChangedWay way(kMillisecond, kLeast);
  way.note();
  (void)way.take(-6'000);
  way.note();
  EXPECT_TRUE(way.take(-9'000));
  for (int i = 0; i < 7; ++i) (void)way.take(-9'000);
  EXPECT_EQ(way.offset(), -9'000);
  way.note();
  EXPECT_FALSE(way.take(-8'500)) << "somebody behind the clock has gone";
  for (int i = 0; i < 7; ++i) (void)way.take(-8'500);
  EXPECT_EQ(way.offset(), -9'000);
  way.note();
  EXPECT_TRUE(way.take(0)) << "all are back";
  EXPECT_EQ(way.offset(), 0);
  way.note();
  (void)way.take(-6'000);
  way.start();
  EXPECT_EQ(way.offset(), 0);
  EXPECT_FALSE(way.take(-6'000));
}

}  // namespace
}  // namespace syncline::dc
