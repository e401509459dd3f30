// SPDX-License-Identifier: Apache-2.0
#include "trace/stretch_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "trace/min_max_series.h"

namespace syncline {
namespace {

/// 1, -2, 3, -4 ... with gaps, a millisecond apart.
MinMaxSeries alternating(int count) {
  MinMaxSeries series;
  for (int i = 1; i <= count; ++i) {
    const bool gap = i % 10 == 0;
    series.append(i * kMillisecond,
                  gap ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i % 2 == 0 ? -i : i));
  }
  return series;
}

TEST(StretchFigures, EverySampleOfTheStretchCountsWhateverThePortions) {
  const auto series = alternating(1000);
  StretchFigures whole, parts;
  whole.aim(&series, 101 * kMillisecond, 201 * kMillisecond);
  EXPECT_FALSE(whole.complete());
  EXPECT_TRUE(whole.work(1'000'000));
  parts.aim(&series, 101 * kMillisecond, 201 * kMillisecond);
  int rounds = 0;
  while (!parts.work(7)) {
    parts.aim(&series, 101 * kMillisecond, 201 * kMillisecond);
    ++rounds;
  }
  EXPECT_GT(rounds, 8);
  EXPECT_EQ(whole.statistics().count(), 90U);
  EXPECT_EQ(parts.statistics().count(), 90U);
  EXPECT_EQ(parts.statistics().rms(), whole.statistics().rms());
  EXPECT_EQ(whole.statistics().min(), -198);
  EXPECT_EQ(whole.statistics().max(), 199);
  EXPECT_EQ(whole.magnitudes().max(), 199);
  double sum = 0;
  for (int i = 101; i <= 200; ++i) sum += i % 10 == 0 ? 0 : i % 2 == 0 ? -i : i;
  EXPECT_NEAR(whole.statistics().mean(), sum / 90, 1e-9);
}

TEST(StretchFigures, BeginsAnewWhereAnythingIsOther) {
  auto series = alternating(100);
  StretchFigures figures;
  EXPECT_TRUE(figures.work(10)) << "of nothing";
  figures.aim(&series, 0, 200 * kMillisecond);
  EXPECT_TRUE(figures.work(1000));
  EXPECT_EQ(figures.statistics().count(), 90U);
  series.append(101 * kMillisecond, 500);
  figures.aim(&series, 0, 200 * kMillisecond);
  EXPECT_FALSE(figures.complete()) << "one came in";
  EXPECT_TRUE(figures.work(1000));
  EXPECT_EQ(figures.magnitudes().max(), 500);
  figures.aim(&series, 0, 50 * kMillisecond);
  EXPECT_TRUE(figures.work(1000));
  EXPECT_EQ(figures.magnitudes().max(), 49);
  figures.aim(&series, 50, 40);
  EXPECT_TRUE(figures.work(1000));
  EXPECT_EQ(figures.statistics().count(), 0U);
  figures.aim(nullptr, 0, 50);
  EXPECT_TRUE(figures.complete());
}

}  // namespace
}  // namespace syncline
