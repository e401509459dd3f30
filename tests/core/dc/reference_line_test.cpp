// SPDX-License-Identifier: Apache-2.0
#include "dc/reference_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/jitter_profile.h"
#include "support/random.h"

namespace syncline::dc {
namespace {

constexpr Nanoseconds kHost = 820'000'000 * kSecond, kReference = 700'000'000 * kSecond;

/// A reference clock that runs 40 ppm fast, read every millisecond through stamps that are wrong by `error`.
struct LineReadings {
  double ppm = 40;
  int count = 0;
  ReferenceLine line;

  LineReadings() { line.start(kHost, kReference); }
  [[nodiscard]] Nanoseconds host() const { return kHost + count * kMillisecond; }
  [[nodiscard]] Nanoseconds truth(Nanoseconds host) const {
    return kReference + (host - kHost) + std::llround(static_cast<double>(host - kHost) * ppm * 1e-6);
  }
  void read(Nanoseconds error) {
    ++count;
    line.observe(host(), truth(host() + error));
  }
  [[nodiscard]] Nanoseconds off(Nanoseconds after = 0) const {
    return line.at(host() + after, ppm) - truth(host() + after);
  }
};

TEST(ReferenceLine, FollowsPlaceAndRate) {
  LineReadings readings;
  for (int i = 0; i < 2'000; ++i) readings.read(0);
  EXPECT_NEAR(readings.off(), 0, 2);
  EXPECT_NEAR(readings.off(10 * kMillisecond), 0, 5);
  EXPECT_NEAR(readings.off(10 * kSecond), 0, 5) << "by the rate that is known over seconds";
}

/// Place and rate are critically damped: there as soon as may be, and not beyond.
TEST(ReferenceLine, FollowsANewRateWithoutGoingBeyond) {
  LineReadings readings;
  for (int i = 0; i < 2'000; ++i) readings.read(0);
  const auto turn = readings.host(), there = readings.truth(turn);
  Nanoseconds most = 0, least = 0, behind = 0;
  for (int i = 1; i <= 400; ++i) {
    const auto passed = i * kMillisecond;
    const auto truth = there + passed + passed / 20'000;  // 50 ppm
    readings.line.observe(turn + passed, truth);
    behind = truth - readings.line.at(turn + passed, 50);
    most = std::max(most, behind);
    least = std::min(least, behind);
  }
  EXPECT_NEAR(most, 229, 4);
  EXPECT_GE(least, -2);
  EXPECT_LT(behind, 12);
}

TEST(ReferenceLine, ASingleWrongStampDoesNotGoOn) {
  LineReadings readings;
  for (int i = 0; i < 2'000; ++i) readings.read(0);
  readings.read(67 * kMicrosecond);
  EXPECT_NEAR(readings.off(), 0, 2);
  readings.read(0);
  EXPECT_NEAR(readings.off(), 0, 2);
}

TEST(ReferenceLine, IsQuieterThanTheStampsOfAHost) {
  LineReadings readings;
  Random random(1);
  const auto host = JitterProfile::quiet();
  double sum = 0, mean = 0;
  for (int i = 0; i < 12'000; ++i) {
    readings.read(std::llround(host.stamp_error.at(random.uniform())));
    if (i < 2'000) continue;
    const auto off = static_cast<double>(readings.off());
    sum += off * off;
    mean += off;
  }
  mean /= 10'000;
  EXPECT_LT(std::sqrt(sum / 10'000 - mean * mean), 120) << "one stamp: 1,770 ns";
}

TEST(ReferenceLine, AStepIsBelievedWhenItStays) {
  LineReadings readings;
  for (int i = 0; i < 500; ++i) readings.read(0);
  for (int i = 0; i < 25; ++i) readings.read(kMillisecond / 4);
  EXPECT_NEAR(readings.off(), kMillisecond / 4, 20);
}

TEST(ReferenceLine, AnotherLeaderIsBelievedAtOnceAndRunsAsFast) {
  LineReadings readings;
  for (int i = 0; i < 500; ++i) readings.read(0);
  readings.line.start_place_anew();
  readings.read(9 * kMicrosecond);
  EXPECT_NEAR(readings.off(), 9 * kMicrosecond, 2);
}

}  // namespace
}  // namespace syncline::dc
