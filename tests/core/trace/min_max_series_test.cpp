// SPDX-License-Identifier: Apache-2.0
#include "trace/min_max_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "support/random.h"

namespace syncline {
namespace {

struct Sample {
  Nanoseconds time;
  float value;
};

/// Irregular times, noise, rare spikes, some gaps.
std::vector<Sample> make_samples(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Sample> samples;
  Nanoseconds time = 820 * kSecond;
  for (std::size_t i = 0; i < count; ++i) {
    time += 1 + static_cast<Nanoseconds>(random.uniform() * 2'000'000);
    float value = static_cast<float>(random.normal() * 10);
    if (random.uniform() < 0.001) value += 5'000;
    if (random.uniform() < 0.01) value = std::numeric_limits<float>::quiet_NaN();
    samples.push_back({time, value});
  }
  return samples;
}

SeriesColumn brute_force(const std::vector<Sample>& samples, Nanoseconds start, Nanoseconds width) {
  SeriesColumn column;
  column.start = start;
  for (const auto& sample : samples) {
    if (sample.time < start || sample.time >= start + width || std::isnan(sample.value)) continue;
    column.min = column.valid ? std::min(column.min, sample.value) : sample.value;
    column.max = column.valid ? std::max(column.max, sample.value) : sample.value;
    column.last = sample.value;
    column.valid = true;
  }
  return column;
}

TEST(MinMaxSeries, ColumnsEqualBruteForceAtEveryZoom) {
  const auto samples = make_samples(20'000, 3);
  MinMaxSeries series(32'768);
  for (const auto& sample : samples) series.append(sample.time, sample.value);
  Random random(4);
  std::vector<SeriesColumn> columns;
  for (int round = 0; round < 40; ++round) {
    const auto span = samples.back().time - samples.front().time;
    const auto begin =
        samples.front().time + static_cast<Nanoseconds>(random.uniform(-0.1, 0.9) * static_cast<double>(span));
    const auto width = 1 + static_cast<Nanoseconds>(std::pow(10.0, random.uniform(3, 10)));
    series.columns(begin, begin + 20 * width, width, columns);
    ASSERT_GE(columns.size(), 20U);
    for (const auto& column : columns) {
      EXPECT_EQ(column.start % width, 0);
      EXPECT_EQ(column, brute_force(samples, column.start, width)) << "width " << width;
    }
  }
}

TEST(MinMaxSeries, InnerColumnsDoNotChangeWhenTheWindowSlides) {
  const auto samples = make_samples(5'000, 5);
  MinMaxSeries series;
  for (const auto& sample : samples) series.append(sample.time, sample.value);
  std::vector<SeriesColumn> reference, moved;
  const Nanoseconds width = 37 * kMillisecond;
  const auto begin = samples.front().time;
  series.columns(begin, begin + 50 * width, width, reference);
  for (Nanoseconds offset = 1; offset < width; offset += width / 7) {
    series.columns(begin + offset, begin + offset + 50 * width, width, moved);
    // The first and last columns may be cut by the window; the others are the same ones, found by their start.
    for (const auto& column : moved) {
      const auto index = static_cast<std::size_t>((column.start - reference.front().start) / width);
      if (index > 0 && index + 1 < reference.size()) {
        EXPECT_EQ(column, reference[index]);
      }
    }
  }
}

TEST(MinMaxSeries, RingForgetsTheOldestAndKeepsTheRestExact) {
  const auto samples = make_samples(60'000, 6);
  MinMaxSeries series(16'384);
  for (const auto& sample : samples) series.append(sample.time, sample.value);
  EXPECT_LE(series.size(), 16'384U);
  EXPECT_GE(series.size(), 16'384U - 4'096U);
  EXPECT_EQ(series.last_time(), samples.back().time);
  const std::vector<Sample> kept(samples.end() - static_cast<std::ptrdiff_t>(series.size()), samples.end());
  EXPECT_EQ(series.first_time(), samples.at(samples.size() - series.size()).time);
  std::vector<SeriesColumn> columns;
  const auto width = (kept.back().time - kept.front().time) / 10;
  series.columns(kept.front().time, kept.back().time + 1, width, columns);
  for (const auto& column : columns) EXPECT_EQ(column, brute_force(kept, column.start, width));
}

TEST(MinMaxSeries, AtGivesTheLastValidValueNotAfterTheTime) {
  MinMaxSeries series;
  series.append(100, 1);
  series.append(200, std::numeric_limits<float>::quiet_NaN());
  series.append(300, 3);
  EXPECT_FALSE(series.at(99));
  EXPECT_EQ(series.at(100)->value, 1);
  EXPECT_EQ(series.at(299)->value, 1);
  EXPECT_EQ(series.at(299)->time, 100);
  EXPECT_EQ(series.at(1'000)->value, 3);
}

/// The value that holds at `time`, NaN when none does.
float held_at(const std::vector<Sample>& samples, Nanoseconds time) {
  float value = std::numeric_limits<float>::quiet_NaN();
  for (const auto& sample : samples) {
    if (sample.time >= time) break;
    value = sample.value;
  }
  return value;
}

TEST(MinMaxSeries, StepColumnsHoldTheValueBefore) {
  const auto samples = make_samples(3'000, 8);
  MinMaxSeries series;
  for (const auto& sample : samples) series.append(sample.time, sample.value);
  Random random(9);
  std::vector<SeriesColumn> columns;
  const auto last_time = samples.back().time;
  for (int round = 0; round < 20; ++round) {
    const auto span = static_cast<double>(last_time - samples.front().time);
    const auto begin = samples.front().time + static_cast<Nanoseconds>(random.uniform(-0.1, 1.0) * span);
    const auto width = 1 + static_cast<Nanoseconds>(std::pow(10.0, random.uniform(4, 8)));
    const auto hold_until = last_time + 5 * width;
    series.step_columns(begin, begin + 30 * width, width, hold_until, columns);
    for (const auto& column : columns) {
      auto expected = brute_force(samples, column.start, width);
      const float before = held_at(samples, column.start);
      if (!std::isnan(before) && (column.start <= last_time || column.start <= hold_until)) {
        expected.min = expected.valid ? std::min(expected.min, before) : before;
        expected.max = expected.valid ? std::max(expected.max, before) : before;
        expected.last = expected.valid ? expected.last : before;
        expected.valid = true;
      }
      EXPECT_EQ(column, expected) << "width " << width;
    }
  }
}

TEST(MinMaxSeries, MemoryGrowsWithTheSamplesAndStopsAtTheCapacity) {
  MinMaxSeries series(1U << 16);
  EXPECT_EQ(series.memory_bytes(), 0U);
  for (int i = 0; i < 200'000; ++i) series.append(i, static_cast<float>(i % 100));
  const auto full = series.memory_bytes();
  EXPECT_LE(full, (1U << 16) * 14U);
  for (int i = 200'000; i < 400'000; ++i) series.append(i, 0);
  EXPECT_EQ(series.memory_bytes(), full);
}

TEST(MinMaxSeries, StartsAnewAfterClear) {
  MinMaxSeries series(8'192);
  for (int i = 0; i < 20'000; ++i) series.append(i, 1'000);
  series.clear();
  EXPECT_TRUE(series.empty());
  for (int i = 0; i < 5'000; ++i) series.append(i, 1);  // earlier than before, and lower
  std::vector<SeriesColumn> columns;
  series.columns(0, 5'000, 5'000, columns);
  ASSERT_EQ(columns.size(), 1U);
  EXPECT_EQ(columns[0].max, 1);
}

TEST(MinMaxSeries, TimeNeverStepsBack) {
  MinMaxSeries series;
  series.append(100, 1);
  series.append(50, 9);
  EXPECT_EQ(series.size(), 1U);
}

/// Many at once are the same as one by one, also where the ring goes round and beside a leader.
TEST(MinMaxSeries, ManyAtOnceAreAsOneByOne) {
  const auto samples = make_samples(60'000, 11);
  MinMaxSeries single(8'192), many(8'192);
  auto single_beside = MinMaxSeries::beside(single), many_beside = MinMaxSeries::beside(many);
  many.reserve(1'000'000);
  Random random(12);
  std::vector<SeriesColumn> expected, columns;
  for (std::size_t done = 0; done < samples.size();) {
    const auto count = std::min<std::size_t>(1 + random.next() % 3'000, samples.size() - done);
    std::vector<Nanoseconds> times;
    std::vector<float> values, others;
    for (std::size_t i = done; i < done + count; ++i) {
      times.push_back(samples[i].time);
      values.push_back(samples[i].value);
      others.push_back(samples[i].value / 2);
      single.append(times.back(), values.back());
      single_beside.append(times.back(), others.back());
    }
    many.append(times, values);
    many_beside.append(times, others);
    done += count;
    for (const auto& [one, all] : {std::pair(&single, &many), std::pair(&single_beside, &many_beside)}) {
      ASSERT_EQ(all->size(), one->size());
      ASSERT_EQ(all->first_time(), one->first_time());
      for (const Nanoseconds width : {3 * kMillisecond, 50 * kMillisecond, 3 * kSecond}) {
        one->columns(one->first_time(), one->last_time() + 1, width, expected);
        all->columns(one->first_time(), one->last_time() + 1, width, columns);
        ASSERT_TRUE(columns == expected) << done;
      }
    }
  }
}

}  // namespace
}  // namespace syncline
