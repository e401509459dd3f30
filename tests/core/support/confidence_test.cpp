// SPDX-License-Identifier: Apache-2.0
#include "support/confidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/random.h"

namespace syncline {
namespace {

constexpr int kRuns = 1'000;

/// Part of the lines whose slope lies in the interval. `alike`: of the rests of neighbouring points, 0..1; `wander`: of
/// the rate from point to point, against the scatter of a point. The truth is the mean rate between both ends.
double covered_slopes(std::size_t points, double alike, double wander) {
  Random random(points);
  int held = 0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<double> x, y;
    double place = 0, rate = 3, rest = random.normal();
    for (std::size_t i = 0; i < points; ++i) {
      x.push_back(static_cast<double>(i));
      y.push_back(place + rest);
      if (i + 1 < points) place += rate;
      rate += wander * random.normal();
      rest = alike * rest + std::sqrt(1 - alike * alike) * random.normal();
    }
    double mean_x = 0, mean_y = 0, common = 0, spread = 0;
    for (std::size_t i = 0; i < points; ++i) {
      mean_x += x[i] / static_cast<double>(points);
      mean_y += y[i] / static_cast<double>(points);
    }
    for (std::size_t i = 0; i < points; ++i) {
      common += (x[i] - mean_x) * (y[i] - mean_y);
      spread += (x[i] - mean_x) * (x[i] - mean_x);
    }
    const auto half = slope_half_width(x, y);
    if (half && std::abs(common / spread - place / static_cast<double>(points - 1)) <= *half) ++held;
  }
  return static_cast<double>(held) / kRuns;
}

TEST(Confidence, StudentsTIsThatOfTheTables) {
  EXPECT_NEAR(student_95(1), 12.706, 1e-3);
  EXPECT_NEAR(student_95(4), 2.776, 1e-3);
  EXPECT_NEAR(student_95(16), 2.120, 1e-3);
  EXPECT_NEAR(student_95(17), 2.110, 1e-3);
  EXPECT_NEAR(student_95(30), 2.042, 1e-3);
  EXPECT_NEAR(student_95(1'000'000), 1.960, 1e-3);
  EXPECT_EQ(student_95(0), student_95(1));
}

TEST(Confidence, TheTrueSlopeIsInsideIn93To97OfAHundredLines) {
  for (const std::size_t points : {6U, 10U, 20U, 41U}) {
    EXPECT_NEAR(covered_slopes(points, 0, 0), 0.95, 0.02) << points;
    EXPECT_NEAR(covered_slopes(points, 0, 0.005), 0.95, 0.02) << points << ", a rate that wanders";
  }
  EXPECT_NEAR(covered_slopes(41, 0.3, 0), 0.95, 0.03);
}

TEST(Confidence, OfTooFewValuesNothingIsSaid) {
  const std::vector<double> few{1, 2, 3, 5, 4};
  EXPECT_FALSE(slope_half_width(few, few));
  EXPECT_FALSE(mean_interval(few));
  const std::vector<double> at_once(20, 1.0);
  EXPECT_FALSE(slope_half_width(at_once, at_once)) << "no line";
  EXPECT_EQ(mean_interval(at_once), (Interval{0, 0}));
  const std::vector<double> unknown(20, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(mean_interval(unknown));
}

TEST(Confidence, OfOneSlowMovementNothingIsSaid) {
  std::vector<double> rising;
  for (int i = 0; i < 64; ++i) rising.push_back(i);
  EXPECT_FALSE(mean_interval(rising));
}

}  // namespace
}  // namespace syncline
