// SPDX-License-Identifier: Apache-2.0
#include "trace/signal_study.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

#include "trace/min_max_series.h"

namespace syncline {
namespace {

constexpr Nanoseconds kBegin = 830'000'000 * kSecond;

/// White noise of -100..100 ns each millisecond; nothing from 6 s to 6.1 s.
MinMaxSeries noise(std::size_t count = 10'000) {
  MinMaxSeries series(count);
  std::mt19937 random(11);
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<float>(static_cast<int>(random() % 201) - 100);
    if (i >= 6000 && i < 6100) continue;
    series.append(kBegin + static_cast<Nanoseconds>(i) * kMillisecond, value);
  }
  return series;
}

TEST(SignalStudy, SaysOnWhatItRests) {
  const auto series = noise();
  const auto study = study_of(EvenSamples(series, kBegin, kBegin + 10 * kSecond, 0), 1e-9);
  EXPECT_NEAR(study.interval, 1e-3, 1e-12);
  EXPECT_EQ(study.given, 9900U);
  EXPECT_EQ(study.used, 9900U);
  EXPECT_EQ(study.gaps, 1U);
  ASSERT_FALSE(study.points.empty());
  // Of white phase noise the Allan deviation is the square root of 3 times its deviation, over tau.
  EXPECT_NEAR(study.points.front().adev, std::sqrt(3) * 58.02e-9 / 1e-3, 0.03 * std::sqrt(3) * 58.02e-9 / 1e-3);
  EXPECT_TRUE(study.reading.jitter);
  EXPECT_GT(study.spectrum.step, 0);
}

/// A step that dies away makes the hump of a swing once; nobody would look for a loop that hunts.
TEST(SignalStudy, OneDisturbanceIsNoHunting) {
  const auto reading = [](auto value) {
    MinMaxSeries series(20'000);
    std::mt19937 random(3);
    for (int i = 0; i < 20'000; ++i)
      series.append(kBegin + i * kMillisecond, static_cast<float>(value(i) + static_cast<int>(random() % 21) - 10));
    return study_of(EvenSamples(series, kBegin, kBegin + 20 * kSecond, 0), 1e-9).reading;
  };
  const auto step = reading([](int i) { return i < 9000 ? 0 : 48'000 * std::exp(-(i - 9000) / 150.0); });
  EXPECT_EQ(step.hunting_period, 0);
  EXPECT_GT(step.disturbed_for, 0.1);
  const auto swing = reading([](int i) { return 500 * std::sin(i / 25.0); });
  EXPECT_GT(swing.hunting_period, 0.08);
  EXPECT_EQ(swing.disturbed_for, 0);
}

TEST(SignalStudy, LeavesOutObservationTimesWithTooFewWindows) {
  const auto series = noise();
  const EvenSamples samples(series, kBegin, kBegin + 6 * kSecond, 0);
  const auto study = study_of(samples, 1e-9);
  const auto all = stability_octaves(samples.stretches(), study.interval, 1e-9);
  EXPECT_LT(study.points.size(), all.size());
  for (const auto& point : study.points) EXPECT_GE(point.windows, kFewestWindows);
  EXPECT_LT(all[study.points.size()].windows, kFewestWindows);
}

TEST(SignalStudy, OfNothingIsEmpty) {
  const auto study = study_of(EvenSamples(MinMaxSeries(), 0, kSecond, 0), 1e-9);
  EXPECT_EQ(study.given, 0U);
  EXPECT_TRUE(study.points.empty());
  EXPECT_EQ(study.spectrum.step, 0);
}

TEST(SignalStudy, EndsEarlyWhenItIsToldTo) {
  const auto series = noise();
  const std::atomic<bool> stop = true;
  const auto study = study_of(EvenSamples(series, kBegin, kBegin + 10 * kSecond, 0), 1e-9, &stop);
  EXPECT_TRUE(study.points.empty());
  EXPECT_TRUE(study.spectrum.amplitudes.empty());
}

TEST(SampleGathering, CopiesInPortionsWhatIsThereAtOnce) {
  const auto series = noise();
  SampleGathering gathering;
  gathering.aim(series, kBegin + kSecond, kBegin + 20 * kSecond, 0);
  int portions = 1;
  for (double before = 0; !gathering.work(1000); ++portions) {
    EXPECT_GT(gathering.progress(), before);
    before = gathering.progress();
  }
  EXPECT_GE(portions, 9) << "about a thousand each";
  EXPECT_LE(portions, 12);
  auto samples = gathering.take();
  samples.finish(0);
  const EvenSamples whole(series, kBegin + kSecond, kBegin + 20 * kSecond, 0);
  EXPECT_EQ(samples.given(), whole.given());
  ASSERT_EQ(samples.stretches().size(), 2U);
  EXPECT_EQ(samples.stretches()[1].size(), whole.stretches()[1].size());
  EXPECT_EQ(samples.interval(), whole.interval());
}

TEST(SampleGathering, WhatLeftTheSeriesIsAGap) {
  constexpr int kCapacity = 8192;
  MinMaxSeries series(kCapacity);
  int next = 0;
  const auto append = [&](int count) {
    for (const int end = next + count; next < end; ++next) series.append(kBegin + next * kMillisecond, 1.F);
  };
  append(kCapacity);
  SampleGathering gathering;
  gathering.aim(series, kBegin, kBegin + kCapacity * kMillisecond, 0);
  EXPECT_FALSE(gathering.work(1000));
  append(3000);
  while (!gathering.work(1000)) {
  }
  auto samples = gathering.take();
  samples.finish(0);
  EXPECT_EQ(samples.gaps(), 1U);
  EXPECT_LT(samples.given(), static_cast<std::size_t>(kCapacity));
}

}  // namespace
}  // namespace syncline
