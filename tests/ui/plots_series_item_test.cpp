// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/series_item.h"

#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <limits>
#include <random>

#include "support/item_picture.h"

namespace syncline::ui {
namespace {

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();
constexpr Nanoseconds kSeriesStart = 830'000'000 * kSecond;  // a date, not zero: float time would lose it
constexpr int kWidth = 400, kHeight = 100;

/// Canvas of kWidth x kHeight for values -50..50.
QImage drawn(SeriesItem& item, Nanoseconds begin, Nanoseconds end) {
  return test::itemPicture(item, ColumnGrid::of(begin, end, kWidth), {kWidth, kHeight}, 50);
}

int darkPixels(const QImage& image, int x, int top, int bottom) {
  int found = 0;
  for (int y = top; y < bottom; ++y) found += qGray(image.pixel(x, y)) < 200 ? 1 : 0;
  return found;
}

MinMaxSeries flat(int samples, int spike_at, float spike) {
  MinMaxSeries series(1U << 18);
  for (int i = 0; i < samples; ++i) series.append(kSeriesStart + i * kMillisecond, i == spike_at ? spike : 0.F);
  return series;
}

TEST(SeriesItem, OneSampleSpikeIsInThePictureAtEveryZoom) {
  constexpr int kSamples = 200'000;
  constexpr int kSpikeAt = 123'457;
  const auto series = flat(kSamples, kSpikeAt, 40);
  const Nanoseconds spike = kSeriesStart + kSpikeAt * kMillisecond;
  SeriesItem item(QStringLiteral("spike"));
  item.setSeries(&series);
  for (Nanoseconds span = 200 * kSecond; span > 40 * kMillisecond; span /= 3) {
    const auto begin = spike - span * 2 / 3;
    const auto image = drawn(item, begin, begin + span);
    const auto grid = ColumnGrid::of(begin, begin + span, kWidth);
    const int column = static_cast<int>(grid.column_of(spike));
    int dark = 0;
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, kWidth - 1); ++x)
      dark += darkPixels(image, x, 10, 40);
    EXPECT_GE(dark, 25) << "span " << span << " ns, column " << column;
    EXPECT_EQ(darkPixels(image, std::max(column - 60, 0), 0, 40), 0) << "only the spike rises";
  }
}

/// Each column has many samples, and none of them lies between the two levels.
TEST(SeriesItem, BarsOfColumnsMeetWhereTheSignalSteps) {
  for (const float to : {30.F, -30.F}) {
    MinMaxSeries series(1U << 18);
    for (int i = 0; i < 40'000; ++i) series.append(kSeriesStart + i * kMillisecond, i < 20'000 ? -to : to);
    SeriesItem item(QStringLiteral("step"));
    item.setSeries(&series);
    const auto image = drawn(item, kSeriesStart, kSeriesStart + 40 * kSecond);
    int longest = 0;
    for (int x = kWidth / 2 - 2; x <= kWidth / 2 + 2; ++x)
      longest = std::max(longest, darkPixels(image, x, 0, kHeight));
    EXPECT_GE(longest, 58) << "to " << to;
  }
}

/// A line that leaves the axis keeps its slope: it is cut there, and no end of it is moved.
TEST(SeriesItem, ALineToAPointOffTheAxisKeepsItsSlope) {
  MinMaxSeries series(1U << 10);
  series.append(kSeriesStart, 0);
  series.append(kSeriesStart + 100 * kMillisecond, 500);  // the axis ends at 50, after a tenth of the way
  series.append(kSeriesStart + 200 * kMillisecond, 0);
  SeriesItem item(QStringLiteral("off"));
  item.setMaxGap(kSecond);
  item.setSeries(&series);
  const auto image = drawn(item, kSeriesStart, kSeriesStart + 200 * kMillisecond);
  // 200 columns lead to the point: after ten of them it is half way to the end of the axis.
  EXPECT_GT(darkPixels(image, 10, 20, 30), 0);
  for (int x = 30; x < 370; ++x) ASSERT_EQ(darkPixels(image, x, 0, kHeight), 0) << x;
  EXPECT_GT(darkPixels(image, 390, 20, 30), 0) << "and it comes back as steep";
}

TEST(SeriesItem, ColumnsAreTheBruteForceExtremes) {
  std::mt19937_64 random(7);
  MinMaxSeries series(1U << 17);
  std::vector<std::pair<Nanoseconds, float>> samples;
  Nanoseconds time = kSeriesStart;
  for (int i = 0; i < 100'000; ++i) {
    time += 100'000 + static_cast<Nanoseconds>(random() % 50'000);
    const auto value = random() % 50 == 0 ? kGap : static_cast<float>(static_cast<double>(random() % 2001) - 1000.0);
    series.append(time, value);
    samples.emplace_back(time, value);
  }
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  for (int round = 0; round < 200; ++round) {
    const auto span = 300 * kMillisecond + static_cast<Nanoseconds>(random() % (10 * kSecond));
    const auto begin =
        kSeriesStart + static_cast<Nanoseconds>(random() % static_cast<std::uint64_t>(time - kSeriesStart));
    const auto grid = ColumnGrid::of(begin, begin + span, 97);
    item.prepare(grid);
    if (item.columns().empty()) continue;
    std::vector<SeriesColumn> wanted(97);
    for (const auto& [at, value] : samples) {
      const auto index = (at - grid.origin) / grid.width;
      if (at < grid.origin || index >= 97 || std::isnan(value)) continue;
      auto& column = wanted[static_cast<std::size_t>(index)];
      column.min = column.valid ? std::min(column.min, value) : value;
      column.max = column.valid ? std::max(column.max, value) : value;
      column.valid = true;
    }
    ASSERT_EQ(item.columns().size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      ASSERT_EQ(item.columns()[i].valid, wanted[i].valid) << "column " << i;
      if (!wanted[i].valid) continue;
      ASSERT_EQ(item.columns()[i].min, wanted[i].min);
      ASSERT_EQ(item.columns()[i].max, wanted[i].max);
    }
  }
}

TEST(SeriesItem, SlidingMovesColumnsWithoutChangingThem) {
  std::mt19937_64 random(11);
  MinMaxSeries series(1U << 16);
  for (int i = 0; i < 60'000; ++i) series.append(kSeriesStart + i * kMillisecond, static_cast<float>(random() % 1000));
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  const auto first = ColumnGrid::of(kSeriesStart + 20 * kSecond, kSeriesStart + 30 * kSecond, kWidth);
  item.prepare(first);
  const auto before = item.columns();
  for (const Nanoseconds slide : {1LL, 999'999LL, 33'000'000LL, 1'234'567'891LL}) {
    const auto grid = ColumnGrid::of(kSeriesStart + 20 * kSecond + slide, kSeriesStart + 30 * kSecond + slide, kWidth);
    EXPECT_EQ(grid.width, first.width);
    EXPECT_EQ((grid.origin - first.origin) % first.width, 0);
    item.prepare(grid);
    const auto shift = static_cast<std::size_t>((grid.origin - first.origin) / first.width);
    for (std::size_t i = shift; i < before.size(); ++i) EXPECT_EQ(item.columns()[i - shift], before[i]) << slide;
  }
}

TEST(SeriesItem, MissingSamplesStayAGap) {
  for (const Nanoseconds step : {kMillisecond, 50 * kMillisecond}) {  // columns, and single samples
    MinMaxSeries series(1U << 16);
    const auto count = 10 * kSecond / step;
    for (Nanoseconds i = 0; i < count; ++i) {
      const bool lost = i * step >= 4 * kSecond && i * step < 6 * kSecond;
      series.append(kSeriesStart + i * step, lost ? kGap : 0.F);
    }
    SeriesItem item(QStringLiteral("x"));
    item.setSeries(&series);
    item.setMaxGap(step * 5 / 2);
    const auto image = drawn(item, kSeriesStart, kSeriesStart + 10 * kSecond);
    EXPECT_EQ(item.columns().empty(), step != kMillisecond);
    EXPECT_GT(darkPixels(image, 100, 45, 55), 0);
    for (int x = 170; x < 230; ++x) EXPECT_EQ(darkPixels(image, x, 0, kHeight), 0) << "x " << x;
    EXPECT_GT(darkPixels(image, 300, 45, 55), 0);
  }
}

TEST(SeriesItem, SamplesFarApartAreNotJoined) {
  MinMaxSeries series;
  series.append(kSeriesStart, 0);
  series.append(kSeriesStart + 100 * kMillisecond, 0);
  series.append(kSeriesStart + 900 * kMillisecond, 0);
  series.append(kSeriesStart + kSecond, 0);
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  item.setMaxGap(250 * kMillisecond);
  const auto image = drawn(item, kSeriesStart, kSeriesStart + kSecond);
  EXPECT_GT(darkPixels(image, 20, 45, 55), 0);
  EXPECT_EQ(darkPixels(image, 200, 0, kHeight), 0);
}

TEST(SeriesItem, CounterIsDrawnAsStepsThatHold) {
  MinMaxSeries series;
  series.append(kSeriesStart, 0);
  series.append(kSeriesStart + 5 * kSecond, 20);
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  item.setShape(SeriesItem::Shape::kStep);
  item.setHoldUntil(kSeriesStart + 8 * kSecond);
  const auto image = drawn(item, kSeriesStart, kSeriesStart + 10 * kSecond);
  EXPECT_GT(darkPixels(image, 190, 48, 52), 0) << "level before the event";
  EXPECT_EQ(darkPixels(image, 190, 0, 46), 0) << "no slope towards the event";
  EXPECT_GT(darkPixels(image, 220, 28, 32), 0) << "level after the event";
  EXPECT_EQ(darkPixels(image, 220, 40, kHeight), 0);
  EXPECT_GT(darkPixels(image, 310, 28, 32), 0) << "holds to the newest sample of the others";
  EXPECT_EQ(darkPixels(image, 360, 0, kHeight), 0) << "but not into the future";
}

TEST(SeriesItem, LevelFromBeforeTheStretchComesIn) {
  MinMaxSeries series;
  series.append(kSeriesStart - 100 * kSecond, 20);
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  item.setShape(SeriesItem::Shape::kStep);
  item.setHoldUntil(kSeriesStart + 10 * kSecond);
  EXPECT_GT(darkPixels(drawn(item, kSeriesStart, kSeriesStart + 10 * kSecond), 200, 28, 32), 0);
  ASSERT_TRUE(item.extent());
  EXPECT_EQ(item.extent()->max, 20);
}

TEST(SeriesItem, RepeatedCounterReadingsCostNoPoints) {
  MinMaxSeries series;
  for (int i = 0; i < 5000; ++i) series.append(kSeriesStart + i * kMillisecond, i < 2500 ? 1.F : 2.F);
  SeriesItem item(QStringLiteral("x"));
  item.setSeries(&series);
  item.setShape(SeriesItem::Shape::kStep);
  item.prepare(ColumnGrid::of(kSeriesStart, kSeriesStart + 5 * kSecond, kWidth));
  EXPECT_LE(item.points().size(), 5U);
}

}  // namespace
}  // namespace syncline::ui
