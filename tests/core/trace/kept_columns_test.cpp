// SPDX-License-Identifier: Apache-2.0
#include "trace/kept_columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.h"

namespace syncline {
namespace {

/// A series to which samples come, some at one time, some of them gaps.
struct Growing {
  explicit Growing(std::size_t capacity) : series(capacity) {}

  void grow(int samples) {
    for (int i = 0; i < samples; ++i) {
      time += static_cast<Nanoseconds>(random.uniform() * 4);  // in ns: many are equal
      const auto value = static_cast<float>(random.normal());
      series.append(time, random.uniform() < 0.1 ? std::numeric_limits<float>::quiet_NaN() : value);
    }
  }

  Random random{7};
  MinMaxSeries series;
  Nanoseconds time = 1'000;
};

void expect_same(KeptColumns& kept, const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end, Nanoseconds width) {
  std::vector<SeriesColumn> fresh;
  series.columns(begin, end, width, fresh);
  EXPECT_EQ(kept.of(series, begin, end, width), fresh) << begin << " to " << end << " by " << width;
}

TEST(KeptColumns, AreThoseOfTheSeriesHoweverTheWindowMovesAndTheSeriesGrows) {
  Growing growing(8192);
  KeptColumns kept;
  auto& random = growing.random;
  Nanoseconds width = 20;
  for (int round = 0; round < 3'000; ++round) {
    const auto what = random.uniform();
    if (what < 0.01) growing.series.clear();
    if (what > 0.97) width = 1 + static_cast<Nanoseconds>(random.uniform() * 200);
    // A recording is shown up to a moment, and whole again before anything comes.
    growing.series.show_until(std::numeric_limits<Nanoseconds>::max());
    growing.grow(static_cast<int>(random.uniform() * 60));
    if (random.uniform() < 0.3)
      growing.series.show_until(growing.time - static_cast<Nanoseconds>(random.uniform() * 9'000));
    // Mostly it follows the newest sample.
    const auto end = growing.time + (what < 0.8 ? 1 : static_cast<Nanoseconds>(random.uniform(-20'000, 5'000)));
    const auto begin = end - static_cast<Nanoseconds>(random.uniform(-10, 20'000));
    expect_same(kept, growing.series, begin, end, width);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(KeptColumns, AnotherSampleAtTheTimeOfTheNewestOneIsSeen) {
  MinMaxSeries series;
  KeptColumns kept;
  series.append(100, 1);
  series.append(109, 2);
  expect_same(kept, series, 100, 110, 10);
  series.append(109, 3);
  expect_same(kept, series, 100, 110, 10);
  EXPECT_EQ(kept.columns().front().max, 3);
}

TEST(KeptColumns, AFilledAnewSeriesIsLookedAtAnew) {
  MinMaxSeries series;
  KeptColumns kept;
  for (int i = 0; i < 100; ++i) series.append(i, 1);
  expect_same(kept, series, 0, 100, 10);
  series.clear();
  for (int i = 0; i < 100; ++i) series.append(i, 2);
  expect_same(kept, series, 0, 100, 10);
  EXPECT_EQ(kept.columns().front().max, 2);
}

}  // namespace
}  // namespace syncline
