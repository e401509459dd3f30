// SPDX-License-Identifier: Apache-2.0
#include "trace/distribution.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace syncline {
namespace {

constexpr Nanoseconds kCounted = 830'000'000 * kSecond;
constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

struct Truth {
  std::vector<std::uint64_t> bins;
  std::uint64_t below = 0, above = 0;
  std::vector<float> values;
};

Truth counted(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end, const BinGrid& grid) {
  Truth truth;
  truth.bins.resize(grid.bins);
  series.for_each(begin, end, [&](Nanoseconds, float value) {
    if (std::isnan(value)) return;
    truth.values.push_back(value);
    const auto v = static_cast<double>(value);
    if (v < grid.low) {
      ++truth.below;
    } else if (v >= grid.high) {
      ++truth.above;
    } else {
      ++truth.bins[static_cast<std::size_t>((v - grid.low) / grid.width())];
    }
  });
  std::ranges::sort(truth.values);
  return truth;
}

void expect_counts(const Distribution& found, const Truth& truth) {
  EXPECT_EQ(std::vector(found.bins().begin(), found.bins().end()), truth.bins);
  EXPECT_EQ(found.below(), truth.below);
  EXPECT_EQ(found.above(), truth.above);
  ASSERT_EQ(found.count(), truth.values.size());
  for (const double fraction : {0.001, 0.5, 0.99, 0.999, 0.9999, 1.0}) {
    const auto quantile = found.quantile(fraction);
    ASSERT_EQ(quantile.has_value(), !truth.values.empty());
    if (!quantile) continue;
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(truth.values.size())));
    const auto exact = static_cast<double>(truth.values[std::max<std::size_t>(rank, 1) - 1]);
    EXPECT_GE(*quantile, exact);
    EXPECT_LE(*quantile, exact + std::abs(exact) / 512);
    if (exact >= 0 && exact <= 1024) {
      EXPECT_EQ(*quantile, exact) << "whole numbers stand alone";
    }
  }
}

TEST(Distribution, WindowsThatMoveCountAsIfCountedAnew) {
  EXPECT_TRUE(rc::check([] {
    MinMaxSeries series(8192);
    Distribution found;
    const BinGrid grid{-64, 192, 32};
    std::mt19937 random(*rc::gen::inRange<unsigned>(0, 10000));
    Nanoseconds now = kCounted;
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3000));
    for (const int step : steps) {
      for (int i = 0; i < step; ++i) {
        now += static_cast<Nanoseconds>(1 + random() % 3);
        series.append(now, random() % 50 == 0 ? kNoValue : static_cast<float>(static_cast<int>(random() % 300) - 80));
      }
      const auto begin = now - static_cast<Nanoseconds>(random() % 20000);
      const auto end = begin + static_cast<Nanoseconds>(random() % 20000);
      found.aim(&series, begin, end, grid);
      const bool all = random() % 2 == 0;
      for (int i = 0; all ? !found.work(500) : i < 3; ++i) {
        if (!all) found.work(500);
        RC_ASSERT(i < 1000);
      }
      if (!found.complete()) continue;
      RC_ASSERT(found.progress() == 1.0);
      expect_counts(found, counted(series, begin, end, grid));
      RC_ASSERT(!testing::Test::HasFailure());
    }
  }));
}

TEST(Distribution, PortionsAreWhatWasAsked) {
  MinMaxSeries series(1U << 18);
  for (int i = 0; i < 200'000; ++i) series.append(kCounted + i * kMillisecond, static_cast<float>(i % 100));
  Distribution found;
  found.aim(&series, kCounted, kCounted + 200 * kSecond, {0, 100, 100});
  EXPECT_FALSE(found.work(50'000));
  EXPECT_NEAR(static_cast<double>(found.count()), 50'000, 10);
  EXPECT_NEAR(found.progress(), 0.25, 0.001);
  while (!found.work(50'000)) {
  }
  EXPECT_EQ(found.count(), 200'000U);
  EXPECT_EQ(found.bins()[42], 2000U);
}

TEST(Distribution, ABinKnowsItsLatestSamples) {
  MinMaxSeries series;
  for (int i = 0; i < 1000; ++i) series.append(kCounted + i, i == 700 ? 900.F : static_cast<float>(i % 10));
  Distribution found;
  found.aim(&series, kCounted, kCounted + 1000, {0, 10, 10});
  found.work(10'000);
  const auto outlier = found.hits(10, 5);
  ASSERT_EQ(outlier.size(), 1U);
  EXPECT_EQ(outlier.front().time, kCounted + 700);
  EXPECT_EQ(outlier.front().value, 900);
  const auto hits = found.hits(3, 4);
  ASSERT_EQ(hits.size(), 4U);
  EXPECT_EQ(hits.front().time, kCounted + 963);
  EXPECT_EQ(hits.back().time, kCounted + 993);
  EXPECT_TRUE(found.hits(-1, 4).empty());
}

TEST(Distribution, NothingIsNothing) {
  Distribution found;
  EXPECT_TRUE(found.work(10));
  EXPECT_EQ(found.quantile(0.5), std::nullopt);
  MinMaxSeries series;
  found.aim(&series, 0, 100, {});
  EXPECT_TRUE(found.work(10));
  EXPECT_EQ(found.count(), 0U);
}

}  // namespace
}  // namespace syncline
