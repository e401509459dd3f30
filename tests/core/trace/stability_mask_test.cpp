// SPDX-License-Identifier: Apache-2.0
#include "trace/stability_mask.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trace/stability.h"

namespace syncline {
namespace {

constexpr auto kMtie = StabilityFigure::kMtie;

TEST(StabilityMask, IsStraightBetweenItsPointsOnLogarithmicAxesAndAsksNothingBeyond) {
  const StabilityMask mask{{{0.01, 100}, {1, 1'000}}};
  EXPECT_DOUBLE_EQ(*mask.at(0.01), 100);
  EXPECT_NEAR(*mask.at(0.1), 316.2278, 1e-3);
  EXPECT_DOUBLE_EQ(*mask.at(1), 1'000);
  EXPECT_EQ(mask.at(0.009998), 100) << "the time that clocks make of it";
  EXPECT_EQ(mask.at(1.0002), 1'000);
  EXPECT_FALSE(mask.at(0.009));
  EXPECT_FALSE(mask.at(1.1));
  EXPECT_FALSE(StabilityMask().at(1));
  EXPECT_EQ((StabilityMask{{{0, 50}}}.at(1e-6)), 50);
}

TEST(StabilityMask, IsTypedWithUnitsOrWithout) {
  EXPECT_EQ(*parse_mask("1ms 100ns; 1s 0.25us", kMtie), (StabilityMask{{{1e-3, 100}, {1, 250}}}));
  EXPECT_EQ(*parse_mask(" 0.001 100 ;1 250; ", kMtie), (StabilityMask{{{1e-3, 100}, {1, 250}}}));
  EXPECT_EQ(*parse_mask("10 ms 1 \u00B5s", kMtie), (StabilityMask{{{1e-2, 1'000}}}));
  EXPECT_EQ(*parse_mask("200", kMtie), (StabilityMask{{{0, 200}}}));
  EXPECT_EQ(*parse_mask("1 1e-9; 10 1e-10", StabilityFigure::kAdev), (StabilityMask{{{1, 1e-9}, {10, 1e-10}}}));
  EXPECT_TRUE(parse_mask("", kMtie)->empty());
}

TEST(StabilityMask, WhatNobodyUnderstandsIsNamed) {
  for (const char* text : {"1 kg 5", "1 0", "-1 5", "1 2 3", "1 5; 1 6", "2 5; 1 6", "5; 1 6", "nan 1", "1 inf", "x",
                           "1s 100ns, 2s 100ns"}) {
    EXPECT_FALSE(parse_mask(text, kMtie)) << text;
  }
  EXPECT_EQ(parse_mask("1s", kMtie)->points.front().value, 1e9) << "a value";
  EXPECT_EQ(parse_mask("1 5; 2 x", kMtie).error().subject, "2 x");
  EXPECT_FALSE(parse_mask("1 5ns", StabilityFigure::kAdev)) << "a rate has no unit of time";
}

TEST(StabilityMask, OfALimitIsWhatValuesWithinItCanShowAtMost) {
  for (const auto figure : {StabilityFigure::kAdev, StabilityFigure::kTdev, kMtie}) {
    const auto mask = mask_of_limit(127, figure, 1e-9);
    for (const double tau : {1e-3, 0.1, 60.0})
      EXPECT_NEAR(*mask.at(tau) / figure_of(stability_bound(127, tau, 1e-9), figure), 1, 1e-9);
  }
  EXPECT_TRUE(mask_of_limit(0, kMtie, 1e-9).empty());
}

TEST(StabilityMask, AViolationIsToldWithItsPlaceAndTheTightestPlaceInAnyCase) {
  std::vector<StabilityPoint> points(4);
  const double taus[] = {0.01, 0.1, 1, 10}, values[] = {50, 400, 900, 5'000};
  for (std::size_t i = 0; i < 4; ++i) {
    points[i].tau = taus[i];
    points[i].mtie = values[i];
  }
  const StabilityMask mask{{{0.01, 100}, {1, 1'000}}};
  const auto verdict = hold_against(points, kMtie, mask);
  EXPECT_EQ(verdict.compared, 3U) << "behind its end the mask asks nothing";
  ASSERT_EQ(verdict.beyond.size(), 1U);
  EXPECT_EQ(verdict.beyond[0].tau, 0.1);
  EXPECT_NEAR(verdict.tightest->ratio(), 400 / 316.2278, 1e-4);
  points[1].mtie = std::nan("");
  const auto kept = hold_against(points, kMtie, mask);
  EXPECT_TRUE(kept.beyond.empty());
  EXPECT_EQ(kept.compared, 2U);
  EXPECT_NEAR(kept.tightest->ratio(), 0.9, 1e-9);
  EXPECT_FALSE(hold_against(points, kMtie, {}).tightest);
}

}  // namespace
}  // namespace syncline
