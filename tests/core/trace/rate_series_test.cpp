// SPDX-License-Identifier: Apache-2.0
#include "trace/rate_series.h"

#include <gtest/gtest.h>

#include <optional>

namespace syncline {
namespace {

constexpr Nanoseconds kStart = 800'000'000 * kSecond;

class RateSeriesTest : public testing::Test {
 protected:
  /// Moments in ms since the start.
  void hear(std::int64_t ms, float value) {
    count.hear(kStart + ms * kMillisecond, value);
    rate.extend(count);
  }
  void lose(std::int64_t ms) {
    count.lose(kStart + ms * kMillisecond);
    rate.extend(count);
  }
  std::optional<float> at(std::int64_t ms) const {
    const auto found = rate.rates().at(kStart + ms * kMillisecond);
    return found ? std::optional(found->value) : std::nullopt;
  }
  HeldSeries count{8192};
  RateSeries rate;
};

TEST_F(RateSeriesTest, IsWhatWasCountedInTheSecondBefore) {
  hear(0, 7);  // what was before is somebody else's
  EXPECT_EQ(at(0), 0);
  hear(500, 10);
  hear(900, 12);
  EXPECT_EQ(at(499), 0);
  EXPECT_EQ(at(500), 3);
  EXPECT_EQ(at(900), 5);
  hear(3000, 12);
  EXPECT_EQ(at(1499), 5);
  EXPECT_EQ(at(1500), 2) << "the first three are a second old";
  EXPECT_EQ(at(1900), 0);
  EXPECT_EQ(rate.rates().heard(), kStart + 3000 * kMillisecond);
}

/// Where nothing new was counted, but somebody heard so: a second later, and not a moment later still.
TEST_F(RateSeriesTest, IsOverWhenNothingWasHeardOfForASecond) {
  hear(0, 0);
  hear(100, 4);
  hear(1099, 4);
  EXPECT_EQ(at(1099), 4);
  hear(1100, 4);
  EXPECT_EQ(at(1100), 0);
  EXPECT_EQ(at(1099), 4);
}

TEST_F(RateSeriesTest, WhatComesAndGoesAtOneMomentIsOneValue) {
  hear(0, 0);
  hear(100, 4);
  hear(1100, 5);
  EXPECT_EQ(at(1100), 1);
}

TEST_F(RateSeriesTest, IsNotKnownWhereTheCountIsNot) {
  hear(0, 0);
  hear(100, 4);
  lose(200);
  EXPECT_EQ(at(250), std::nullopt);
  hear(400, 90);
  EXPECT_EQ(at(250), std::nullopt);
  EXPECT_EQ(at(400), 0) << "nobody knows when these came";
}

TEST_F(RateSeriesTest, ACountThatGoesBackWasCleared) {
  hear(0, 100);
  hear(100, 3);
  EXPECT_EQ(at(100), 3);
}

/// Drawn at once or bit by bit: the same.
TEST_F(RateSeriesTest, DoesNotDependOnWhenSomebodyLooks) {
  for (int i = 0; i < 400; ++i) hear(i * 37, static_cast<float>(i * i % 1000));
  RateSeries once;
  once.extend(count);
  ASSERT_EQ(once.rates().series().size(), rate.rates().series().size());
  once.rates().series().for_each(kStart, kStart + 1000 * kSecond, [&](Nanoseconds time, float value) {
    const auto other = rate.rates().at(time);
    ASSERT_TRUE(other);
    EXPECT_EQ(other->value, value);
  });
}

}  // namespace
}  // namespace syncline
