// SPDX-License-Identifier: Apache-2.0
#include "trace/spectrum.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "config/dcm_settings.h"
#include "config/network_config.h"
#include "trace/even_samples.h"
#include "trace/min_max_series.h"

namespace syncline {
namespace {

constexpr Nanoseconds kSampled = 830'000'000 * kSecond;

Spectrum spectrum(const std::vector<float>& samples, double interval) {
  const std::span<const float> stretch(samples);
  return spectrum_of(Stretches<float>(&stretch, 1), interval);
}

TEST(Spectrum, FindsInjectedLines) {
  EXPECT_TRUE(rc::check([] {
    const double interval = 1 / (*rc::gen::element(250.0, 1000.0, 8000.0));
    const auto size = *rc::gen::inRange<std::size_t>(2000, 20000);
    const double nyquist = 0.5 / interval;
    // Two lines far enough from each other, and with enough turns to be called lines.
    const double first = nyquist * *rc::gen::inRange(30, 400) / 1000;
    const double second = nyquist * *rc::gen::inRange(500, 950) / 1000;
    const double amplitude = *rc::gen::inRange(20, 500);
    const double phase = *rc::gen::inRange(0, 628) / 100.0;
    std::mt19937 random(*rc::gen::inRange(0, 1000));
    // Of an amplitude it is 0.08 at most (root of 3 / samples): far below what is asked for.
    std::normal_distribution<double> noise(0, 2);
    std::vector<float> samples;
    for (std::size_t i = 0; i < size; ++i) {
      const double t = 2 * std::numbers::pi * static_cast<double>(i) * interval;
      samples.push_back(static_cast<float>(700 + 0.01 * static_cast<double>(i) + noise(random) +
                                           amplitude * std::sin(first * t + phase) +
                                           amplitude / 2 * std::sin(second * t)));
    }
    const auto found = spectrum(samples, interval);
    RC_ASSERT(found.used == size);
    RC_ASSERT(found.peaks.size() >= 2U);
    RC_ASSERT(std::abs(found.peaks[0].frequency - first) <= 0.01 * first);
    RC_ASSERT(std::abs(found.peaks[0].amplitude - amplitude) <= 0.1 * amplitude);
    RC_ASSERT(std::abs(found.peaks[1].frequency - second) <= 0.01 * second);
    RC_ASSERT(std::abs(found.peaks[1].amplitude - amplitude / 2) <= 0.05 * amplitude);
  }));
}

/// Mean and slope are no lines, wherever the window stands.
TEST(Spectrum, AStraightLineHasNothing) {
  std::vector<float> samples(1024);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = 4'000 - 3 * static_cast<float>(i);
  const auto found = spectrum(samples, 0.001);
  ASSERT_FALSE(found.amplitudes.empty());
  for (const double amplitude : found.amplitudes) EXPECT_LT(amplitude, 1e-6);
}

TEST(Spectrum, NoiseHasNoLines) {
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 50);
  std::vector<float> samples(100'000);
  for (auto& sample : samples) sample = noise(random);
  EXPECT_TRUE(spectrum(samples, 0.001).peaks.empty());
  std::ranges::fill(samples, 5.F);
  EXPECT_TRUE(spectrum(samples, 0.001).peaks.empty());
  EXPECT_EQ(spectrum({1, 2, 3}, 0.001).step, 0);
}

TEST(Spectrum, NamesWhatFits) {
  const double periods[] = {0.004};
  const auto known = known_frequencies(0.001, 12.5, periods);
  const auto kind = [&](double frequency, double rate = 1000) {
    const auto* cause = likely_cause({frequency, 10}, known, rate, 0.001);
    return cause == nullptr ? -1 : static_cast<int>(cause->kind);
  };
  EXPECT_EQ(kind(0.0125), static_cast<int>(KnownFrequency::Kind::kBeat));
  EXPECT_EQ(kind(250.1), static_cast<int>(KnownFrequency::Kind::kTask));
  EXPECT_EQ(kind(50), static_cast<int>(KnownFrequency::Kind::kMains));
  EXPECT_EQ(kind(42, 92), static_cast<int>(KnownFrequency::Kind::kMains)) << "50 Hz, folded at 46 Hz";
  EXPECT_EQ(kind(37), -1);
}

TEST(Spectrum, NamesTheLoopOfTheMasterSynchronisation) {
  NetworkConfig config;
  config.cyclic.resize(2);
  config.cyclic[0].cycle_time = kMillisecond;
  config.cyclic[1].cycle_time = 4 * kMillisecond;
  config.dc.enabled = true;
  config.dc.dcm.mode = DcmMode::kMasterShift;
  config.dc.dcm.gain_ppt = 100;  // swings at 0.05 * sqrt(2) radians a cycle
  config.dc.dcm.drift_error_gain = 3;
  const auto kind = [&](double frequency) {
    const auto known = known_frequencies(config, kMillisecond, 0);
    const auto* cause = likely_cause({frequency, 10}, known, 1000, 0.001);
    return cause == nullptr ? -1 : static_cast<int>(cause->kind);
  };
  EXPECT_EQ(kind(250), static_cast<int>(KnownFrequency::Kind::kTask));
  EXPECT_EQ(kind(9.5), static_cast<int>(KnownFrequency::Kind::kLoop)) << "11.25 Hz, and it is damped";
  EXPECT_EQ(kind(7), -1);
  config.dc.dcm.mode = DcmMode::kBusShift;
  EXPECT_EQ(kind(9.5), -1);
}

TEST(EvenSamples, SplitsAtGapsAndSaysWhatItUsed) {
  MinMaxSeries series;
  for (int i = 0; i < 1000; ++i) {
    if (i >= 300 && i < 350) continue;                           // nothing came
    const Nanoseconds late = i == 700 ? 300 * kMicrosecond : 0;  // is no gap
    const float value = i == 500 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i);
    series.append(kSampled + i * kMillisecond + late, value);
  }
  const EvenSamples samples(series, kSampled, kSampled + kSecond, 20 * kMillisecond);
  EXPECT_EQ(samples.given(), 949U);
  EXPECT_EQ(samples.used(), 949U);
  EXPECT_EQ(samples.uneven(), 2U) << "to the late one and from it";
  ASSERT_EQ(samples.stretches().size(), 3U);
  EXPECT_EQ(samples.gaps(), 2U);
  EXPECT_EQ(samples.stretches()[0].size(), 300U);
  EXPECT_EQ(samples.stretches()[1].front(), 350);
  EXPECT_EQ(samples.stretches()[2].size(), 499U);
  EXPECT_NEAR(samples.interval(), 1e6, 1e-6);
  const EvenSamples few(series, kSampled + 295 * kMillisecond, kSampled + 360 * kMillisecond, 0);
  EXPECT_EQ(few.given(), 15U);
  EXPECT_EQ(few.used(), 10U) << "five samples in front of the gap are too few for anything";
}

}  // namespace
}  // namespace syncline
