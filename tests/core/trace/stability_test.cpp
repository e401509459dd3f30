// SPDX-License-Identifier: Apache-2.0
#include "trace/stability.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "nist_frequencies.h"

namespace syncline {
namespace {

using Points = std::vector<double>;

StabilityPoint at(const Points& x, std::size_t m, double interval = 1, double unit = 1) {
  const std::span<const double> stretch(x);
  return stability_at(Stretches<double>(&stretch, 1), m, interval, unit);
}

/// The definitions, word for word.
StabilityPoint brute_force(const Points& x, std::size_t m, double interval) {
  const auto n = x.size();
  StabilityPoint point;
  point.tau = static_cast<double>(m) * interval;
  const auto second = [&](std::size_t i) { return x[i + 2 * m] - 2 * x[i + m] + x[i]; };
  const auto root_mean = [](double sum, std::size_t terms) { return std::sqrt(sum / static_cast<double>(terms)); };
  const double scale = 1 / (std::sqrt(2.0) * point.tau);
  double sum = 0;
  for (std::size_t i = 0; i + 2 * m < n; ++i) sum += second(i) * second(i);
  point.terms = n > 2 * m ? n - 2 * m : 0;
  for (std::size_t i = 0; i + m < n; i += m) ++point.windows;
  point.adev = scale * root_mean(sum, point.terms);
  sum = 0;
  std::size_t terms = 0;
  for (std::size_t i = 0; i + 2 * m < n; i += m, ++terms) sum += second(i) * second(i);
  point.plain_adev = scale * root_mean(sum, terms);
  sum = 0;
  terms = 0;
  for (std::size_t j = 0; j + 3 * m <= n; ++j, ++terms) {
    double inner = 0;
    for (std::size_t i = j; i < j + m; ++i) inner += second(i);
    sum += inner * inner;
  }
  point.mdev = scale / static_cast<double>(m) * root_mean(sum, terms);
  point.tdev = point.tau / std::sqrt(3.0) * point.mdev;
  sum = 0;
  point.mtie = n > m ? 0 : std::nan("");
  for (std::size_t i = 0; i + m < n; ++i) {
    sum += (x[i + m] - x[i]) * (x[i + m] - x[i]);
    const auto begin = x.begin() + static_cast<std::ptrdiff_t>(i);
    const auto [low, high] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(m) + 1);
    point.mtie = std::max(point.mtie, *high - *low);
  }
  point.tie_rms = root_mean(sum, n > m ? n - m : 0);
  return point;
}

void expect_same(double found, double wanted, const char* what) {
  if (std::isnan(wanted)) {
    EXPECT_TRUE(std::isnan(found)) << what;
  } else {
    EXPECT_NEAR(found, wanted, 1e-9 * std::abs(wanted)) << what;
  }
}

void expect_same(const StabilityPoint& found, const StabilityPoint& wanted) {
  expect_same(found.tau, wanted.tau, "tau");
  expect_same(found.adev, wanted.adev, "overlapping Allan deviation");
  expect_same(found.plain_adev, wanted.plain_adev, "Allan deviation");
  expect_same(found.mdev, wanted.mdev, "modified Allan deviation");
  expect_same(found.tdev, wanted.tdev, "time deviation");
  expect_same(found.tie_rms, wanted.tie_rms, "time interval error");
  expect_same(found.mtie, wanted.mtie, "maximum time interval error");
  EXPECT_EQ(found.terms, wanted.terms);
  EXPECT_EQ(found.windows, wanted.windows);
}

TEST(Stability, NistTestSet) {
  const auto y = nist_frequencies();
  const auto [low, high] = std::ranges::minmax_element(y);
  EXPECT_NEAR(*low, 1.371760e-03, 5e-9);
  EXPECT_NEAR(*high, 9.957453e-01, 5e-7);
  const auto x = phases_of(y);
  struct Row {
    std::size_t m;
    double plain, overlapping, modified, time;
  };
  for (const auto& row : {Row{1, 2.922319e-01, 2.922319e-01, 2.922319e-01, 1.687202e-01},
                          Row{10, 9.965736e-02, 9.159953e-02, 6.172376e-02, 3.563623e-01},
                          Row{100, 3.897804e-02, 3.241343e-02, 2.170921e-02, 1.253382e+00}}) {
    const auto point = at(x, row.m);
    EXPECT_NEAR(point.plain_adev, row.plain, 5e-7 * row.plain) << row.m;
    EXPECT_NEAR(point.adev, row.overlapping, 5e-7 * row.overlapping) << row.m;
    EXPECT_NEAR(point.mdev, row.modified, 5e-7 * row.modified) << row.m;
    EXPECT_NEAR(point.tdev, row.time, 5e-7 * row.time) << row.m;
    expect_same(point, brute_force(x, row.m, 1));
  }
}

TEST(Stability, IsWhatTheDefinitionsSay) {
  EXPECT_TRUE(rc::check([] {
    const auto size = *rc::gen::inRange<std::size_t>(2, 200);
    const auto x = *rc::gen::container<Points>(
        size, rc::gen::map(rc::gen::inRange(-100000, 100000), [](int value) { return value / 16.0; }));
    const auto m = *rc::gen::inRange<std::size_t>(1, 70);
    expect_same(at(x, m, 0.001), brute_force(x, m, 0.001));
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

TEST(Stability, OctavesAreTheSameAsSinglePoints) {
  std::mt19937 random(5);
  Points x(1500);
  std::vector<float> narrow;
  for (auto& value : x) narrow.push_back(static_cast<float>(value = static_cast<int>(random() % 2001) - 1000));
  const std::span<const double> whole(x);
  const std::span<const float> floats(narrow);
  const auto points = stability_octaves(Stretches<double>(&whole, 1), 0.001, 1e-9);
  const auto of_floats = stability_octaves(Stretches<float>(&floats, 1), 0.001, 1e-9);
  ASSERT_EQ(points.size(), 10U) << "1 .. 512 intervals";
  ASSERT_EQ(of_floats.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect_same(points[i], at(x, std::size_t{1} << i, 0.001, 1e-9));
    expect_same(of_floats[i], points[i]);
  }
}

TEST(Stability, NoTermReachesAcrossAGap) {
  Points x(600);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = i < 300 ? 0 : 1e6;
  const std::span<const double> all(x);
  const std::vector<std::span<const double>> parts{all.first(300), all.last(300)};
  for (const auto& point : stability_octaves(Stretches<double>(parts), 1, 1e-9)) {
    EXPECT_EQ(point.adev, 0);
    EXPECT_EQ(point.mtie, 0);
    EXPECT_EQ(point.terms, 2 * (300 - 2 * static_cast<std::size_t>(point.tau)));
    EXPECT_EQ(point.windows, 2 * (299 / static_cast<std::size_t>(point.tau)));
  }
}

TEST(Stability, TooFewSamplesAreNoPoints) {
  const Points x{1, 2};
  const std::span<const double> stretch(x);
  EXPECT_TRUE(stability_octaves(Stretches<double>(&stretch, 1), 1, 1).empty());
  EXPECT_TRUE(stability_octaves(Stretches<double>(), 1, 1).empty());
  EXPECT_TRUE(std::isnan(at(x, 1).adev));
  EXPECT_TRUE(std::isnan(at(x, 5).mtie));
}

/// Points of what `value` gives for a sample.
StabilityReading reading_of(const std::function<double(std::size_t)>& value, std::size_t count = 8192) {
  Points x(count);
  for (std::size_t i = 0; i < count; ++i) x[i] = value(i);
  const std::span<const double> stretch(x);
  return read_stability(stability_octaves(Stretches<double>(&stretch, 1), 0.001, 1e-9));
}

TEST(Stability, TellsJitterHuntingAndDriftApart) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 20);
  const auto jitter = reading_of([&](std::size_t) { return noise(random); });
  EXPECT_TRUE(jitter.jitter);
  EXPECT_NEAR(jitter.short_slope.value(), -1, 0.05) << "white phase noise";
  EXPECT_EQ(jitter.runs_away, 0);
  EXPECT_FALSE(jitter.drift);
  EXPECT_EQ(jitter.hunting_period, 0);
  const auto hunting = reading_of([&](std::size_t i) {
    return noise(random) + 100 * std::sin(2 * std::numbers::pi * static_cast<double>(i) * 0.001 / 0.16);
  });
  EXPECT_NEAR(hunting.hunting_period, 0.16, 0.16) << "an octave";
  EXPECT_GT(hunting.hunting_period, 0.08);
  const auto drift =
      reading_of([&](std::size_t i) { return noise(random) + 1e-4 * static_cast<double>(i) * static_cast<double>(i); });
  EXPECT_TRUE(drift.jitter);
  EXPECT_TRUE(drift.drift);
  EXPECT_GT(drift.long_slope.value(), 0.4);
}

TEST(Stability, ARateThatStaysIsToldThoughTheAllanDeviationDoesNotSeeIt) {
  const auto ramp = reading_of([](std::size_t i) { return 0.25 * static_cast<double>(i); });
  EXPECT_NEAR(ramp.runs_away, 250, 1e-6) << "ns a second";
  EXPECT_FALSE(ramp.drift);
  EXPECT_EQ(reading_of([](std::size_t i) { return i % 2 == 0 ? 4 : -4; }).runs_away, 0);
}

TEST(Stability, FewSamplesSaySoByNothing) {
  std::mt19937 random(3);
  const auto reading = reading_of([&](std::size_t) { return static_cast<double>(random() % 100); }, 36);
  EXPECT_FALSE(reading.short_slope);
  EXPECT_FALSE(reading.jitter);
}

TEST(Stability, EndsEarlyWhenItIsToldTo) {
  const Points x(4000);
  const std::span<const double> stretch(x);
  const std::atomic<bool> stop = true;
  EXPECT_TRUE(stability_octaves(Stretches<double>(&stretch, 1), 1, 1, &stop).empty());
}

/// Values that alternate between both ends come to it.
TEST(Stability, TheBoundIsNoHigherThanNeeded) {
  Points x(64);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = i % 2 == 0 ? 50 : -50;
  const auto worst = at(x, 1, 0.5, 1e-9);
  const auto bound = stability_bound(50, 0.5, 1e-9);
  expect_same(bound.tau, worst.tau, "tau");
  expect_same(bound.adev, worst.adev, "overlapping Allan deviation");
  expect_same(bound.plain_adev, worst.plain_adev, "Allan deviation");
  expect_same(bound.mdev, worst.mdev, "modified Allan deviation");
  expect_same(bound.tdev, worst.tdev, "time deviation");
  expect_same(bound.tie_rms, worst.tie_rms, "time interval error");
  expect_same(bound.mtie, worst.mtie, "maximum time interval error");
}

TEST(Stability, NothingWithinTheLimitGoesAboveItsBound) {
  EXPECT_TRUE(rc::check([] {
    const auto size = *rc::gen::inRange<std::size_t>(4, 100);
    const auto x = *rc::gen::container<Points>(
        size, rc::gen::map(rc::gen::inRange(-50, 51), [](int value) { return static_cast<double>(value); }));
    const std::span<const double> stretch(x);
    for (const auto& point : stability_octaves(Stretches<double>(&stretch, 1), 0.5, 1e-9)) {
      const auto bound = stability_bound(50, point.tau, 1e-9);
      const double slack = 1 + 1e-12;
      RC_ASSERT(!(point.adev > bound.adev * slack));
      RC_ASSERT(!(point.mdev > bound.mdev * slack));
      RC_ASSERT(!(point.tdev > bound.tdev * slack));
      RC_ASSERT(!(point.mtie > bound.mtie * slack));
      RC_ASSERT(!(point.tie_rms > bound.tie_rms * slack));
    }
  }));
}

}  // namespace
}  // namespace syncline
