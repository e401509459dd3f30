// SPDX-License-Identifier: Apache-2.0
#include "trace/arrival_figures.h"

#include <gtest/gtest.h>

#include <limits>

#include "trace/min_max_series.h"

namespace syncline {
namespace {

TEST(ArrivalFigures, AreOfEveryArrivalInTheStretch) {
  MinMaxSeries phase(8192);
  for (int i = 0; i < 2'000; ++i) phase.append(i, i == 700 ? 999'000.0F : 400'000.0F + static_cast<float>(i % 2));
  phase.append(2'000, std::numeric_limits<float>::quiet_NaN());
  phase.append(2'001, 5.0F);
  const auto figures = arrival_figures(phase, kMillisecond, 0, 2'001, 10);
  EXPECT_EQ(figures.count, 2'000U);
  EXPECT_EQ(figures.bins[4], (ArrivalFigures::Bin{1'999, 1'999}));
  EXPECT_EQ(figures.bins[9], (ArrivalFigures::Bin{1, 700}));
  EXPECT_EQ(figures.bins[0], ArrivalFigures::Bin{}) << "behind the stretch";
  EXPECT_EQ(figures.margin_min, 1'000);
  EXPECT_EQ(figures.margin_p999, 599'999) << "one of two thousand is less than a thousandth";
}

TEST(ArrivalFigures, WithoutArrivalsThereIsNoMargin) {
  const auto figures = arrival_figures(MinMaxSeries(1), kMillisecond, 0, kSecond, 4);
  EXPECT_EQ(figures.count, 0U);
  EXPECT_FALSE(figures.margin_min);
  EXPECT_FALSE(figures.margin_p999);
}

}  // namespace
}  // namespace syncline
