// SPDX-License-Identifier: Apache-2.0
#include "trace/histogram.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace syncline {
namespace {

/// The exact order statistic that the histogram's percentile stands for.
std::int64_t exact_percentile(std::vector<std::int64_t> values, double fraction) {
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

TEST(Histogram, PercentilesNeverUnderstateAndOverstateByABinAtMost) {
  EXPECT_TRUE(rc::check([] {
    const auto exponents = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 40)));
    std::vector<std::int64_t> values;
    for (const int exponent : exponents)
      values.push_back(*rc::gen::inRange<std::int64_t>(0, (std::int64_t{1} << exponent) + 1));
    Histogram histogram;
    for (const auto value : values) histogram.add(value);
    for (const double fraction : {0.01, 0.5, 0.9, 0.99, 0.999, 1.0}) {
      const auto exact = exact_percentile(values, fraction);
      const auto found = histogram.percentile(fraction);
      RC_ASSERT(found >= exact);
      RC_ASSERT(found <= exact + exact / 32);
    }
    RC_ASSERT(histogram.max() == *std::max_element(values.begin(), values.end()));
    RC_ASSERT(histogram.min() == *std::min_element(values.begin(), values.end()));
  }));
}

TEST(Histogram, TakesTheWholeRange) {
  Histogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0);
  histogram.add(std::numeric_limits<std::int64_t>::max());
  histogram.add(-5);
  EXPECT_EQ(histogram.count(), 2U);
  EXPECT_EQ(histogram.min(), 0);
  EXPECT_EQ(histogram.percentile(1.0), std::numeric_limits<std::int64_t>::max());
  histogram.clear();
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_TRUE(histogram.bins().empty());
}

}  // namespace
}  // namespace syncline
