// SPDX-License-Identifier: Apache-2.0
#include "trace/arrival_bathtub.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/random.h"
#include "trace/min_max_series.h"

namespace syncline {
namespace {

constexpr Nanoseconds kPeriod = kMillisecond;

MinMaxSeries arrivals(std::size_t count, const std::function<double(std::size_t)>& phase) {
  MinMaxSeries series(count);
  for (std::size_t i = 0; i < count; ++i)
    series.append(static_cast<Nanoseconds>(i) * kPeriod, static_cast<float>(phase(i)));
  return series;
}

ArrivalBathtub bathtub_of(const MinMaxSeries& series) {
  return arrival_bathtub(series, kPeriod, 0, std::numeric_limits<Nanoseconds>::max());
}

TEST(ArrivalBathtub, RoomsAreThoseThatWereSeenAsFarAsTenPeriodsHadLess) {
  // 0 to 99,999 ns behind SYNC0, each once.
  const auto series = arrivals(100'000, [](std::size_t i) { return static_cast<double>(i * 7'919 % 100'000); });
  const auto found = bathtub_of(series);
  EXPECT_EQ(found.count, 100'000U);
  for (const auto& point : found.early) {
    if (point.extrapolated) continue;
    EXPECT_NEAR(point.room, point.probability * 100'000, 1) << point.probability;
    EXPECT_GE(point.probability, 1e-4 * 0.999);
  }
  for (const auto& point : found.late) {
    if (!point.extrapolated) {
      EXPECT_NEAR(point.room, 900'000 + point.probability * 100'000, 1.5);
    }
  }
  const auto rare = ArrivalBathtub::room(found.late, 1e-3);
  ASSERT_TRUE(rare);
  EXPECT_FALSE(rare->extrapolated);
  EXPECT_NEAR(rare->room, 900'100, 2);
}

/// Frames that come with a SYNC0 are early ones of the period that it begins.
TEST(ArrivalBathtub, WhoComesWithSync0HasAPeriodLeft) {
  for (const double phase : {0.0, 0.5, 3.0}) {
    const auto found = bathtub_of(arrivals(100, [phase](std::size_t) { return phase; }));
    ASSERT_FALSE(found.late.empty() || found.early.empty());
    EXPECT_NEAR(found.early.front().room, phase, 1e-3);
    EXPECT_NEAR(found.late.front().room, kPeriod - phase, 1e-3);
  }
}

TEST(ArrivalBathtub, GoesOnAsTheRarestOnesBeginAndSaysSo) {
  // Late by an exponential time of 2 us: room at p is 600 us - 2 us * ln(1/p), known for every p.
  Random random(3);
  const auto series = arrivals(200'000, [&](std::size_t) { return 400'000 - 2'000 * std::log(1 - random.uniform()); });
  const auto found = bathtub_of(series);
  for (const double probability : {1e-2, 1e-3, 1e-6, 1e-9}) {
    const auto point = ArrivalBathtub::room(found.late, probability);
    ASSERT_TRUE(point) << probability;
    const double lost = 2'000 * std::log(1 / probability);
    EXPECT_NEAR(point->room, 600'000 - lost, 0.06 * lost) << probability;
    EXPECT_EQ(point->extrapolated, probability < 1e-4) << probability;
  }
  double before = kPeriod;
  for (const auto& point : found.late) {
    EXPECT_LE(point.room, before);
    before = point.room;
  }
}

TEST(ArrivalBathtub, WhatHappenedOnceIsNoRarerThanThat) {
  const auto series = arrivals(
      100'000, [](std::size_t i) { return i == 50'000 ? 700'000.0 : 300'000.0 + static_cast<double>(i % 100); });
  const auto found = bathtub_of(series);
  const auto rare = ArrivalBathtub::room(found.late, 1e-6);
  ASSERT_TRUE(rare);
  EXPECT_TRUE(rare->extrapolated);
  EXPECT_LE(rare->room, 300'000);
}

TEST(ArrivalBathtub, AnArrivalBeyondSync0HasNegativeRoom) {
  // Most come 20 us in front of SYNC0, one in twenty 30 us behind it.
  const auto series = arrivals(10'000, [](std::size_t i) { return i % 20 == 0 ? 30'000.0 : 980'000.0; });
  const auto found = bathtub_of(series);
  EXPECT_EQ(ArrivalBathtub::room(found.late, 1e-2)->room, -30'000);
  EXPECT_EQ(ArrivalBathtub::room(found.late, 0.5)->room, 20'000);
  EXPECT_EQ(ArrivalBathtub::room(found.early, 1e-2)->room, 980'000);
}

TEST(ArrivalBathtub, TellsHowOftenLessThanANeedIsKept) {
  const auto series = arrivals(100'000, [](std::size_t i) { return static_cast<double>(i * 7'919 % 100'000); });
  const auto found = bathtub_of(series);
  const auto seldom = ArrivalBathtub::less_than(found.early, 500);
  ASSERT_TRUE(seldom);
  EXPECT_GE(seldom->probability, 0.005 * 0.999);
  EXPECT_LE(seldom->probability, 0.005 * 1.34);
  EXPECT_FALSE(seldom->extrapolated);
  EXPECT_FALSE(ArrivalBathtub::less_than(found.late, 500'000));
  EXPECT_EQ(ArrivalBathtub::less_than(found.early, 2e6)->probability, 1);
}

TEST(ArrivalBathtub, OfFewArrivalsNothingIsExtrapolated) {
  const auto series = arrivals(1'000, [](std::size_t i) { return 300'000.0 + static_cast<double>(i); });
  const auto found = bathtub_of(series);
  EXPECT_FALSE(ArrivalBathtub::room(found.late, 1e-6));
  EXPECT_TRUE(ArrivalBathtub::room(found.late, 1e-2));
  for (const auto& point : found.late) EXPECT_FALSE(point.extrapolated);
  EXPECT_TRUE(bathtub_of(MinMaxSeries()).late.empty());
}

}  // namespace
}  // namespace syncline
