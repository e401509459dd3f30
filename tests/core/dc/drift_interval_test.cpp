// SPDX-License-Identifier: Apache-2.0
// How sure the drift is that a controller states, held against clocks whose rate is known.
#include <gtest/gtest.h>

#include <cmath>

#include "dc/dcm/drift_estimator.h"
#include "support/jitter_profile.h"
#include "support/random.h"

namespace syncline::dc {
namespace {

struct DriftCase {
  JitterProfile host;
  Nanoseconds cycle = kMillisecond;
  double wander = 0;  // ppm, of the rate from one 100 ms to the next
  Nanoseconds lasting = 6 * kSecond;
};

struct DriftCoverage {
  double held = 0, mean_half = 0;
  int stated = 0;
};

/// The truth is the mean rate over what the line is made of: the last four seconds, or all where that is less.
DriftCoverage drift_coverage(const DriftCase& of, int runs) {
  Random random(42);
  DriftCoverage found;
  for (int run = 0; run < runs; ++run) {
    DriftEstimator drift;
    double rate = random.uniform(-80, 80), place = random.uniform(0, 1e6);
    Nanoseconds next_rate = 0;
    std::vector<std::pair<Nanoseconds, double>> places;
    for (Nanoseconds time = 0; time < of.lasting; time += of.cycle) {
      if (time >= next_rate) {
        rate += of.wander * random.normal();
        next_rate += 100 * kMillisecond;
      }
      const double late = of.host.stamp_error.empty() ? 0 : of.host.stamp_error.at(random.uniform());
      // The clock counts in ticks of 10 ns and is read when the frame leaves, later than its stamp says.
      const auto shown = std::floor((place + late) / 10) * 10;
      (void)drift.observe(time, time + static_cast<Nanoseconds>(shown));
      places.emplace_back(time, place);
      place += rate * 1e-6 * static_cast<double>(of.cycle);
    }
    if (!drift.half_width_ppm()) continue;
    const auto span = std::min<Nanoseconds>(4 * kSecond, of.lasting);
    const auto& from = places[places.size() - static_cast<std::size_t>(span / of.cycle)];
    const auto& to = places.back();
    const double truth = (to.second - from.second) / static_cast<double>(to.first - from.first) * 1e6;
    ++found.stated;
    found.mean_half += *drift.half_width_ppm();
    if (std::abs(drift.ppm() - truth) <= *drift.half_width_ppm()) found.held += 1;
  }
  found.held /= std::max(found.stated, 1);
  found.mean_half /= std::max(found.stated, 1);
  return found;
}

TEST(DriftInterval, HoldsTheTruthIn93To97OfAHundredRuns) {
  for (const auto& host : {JitterProfile::quiet(), JitterProfile::desktop()}) {
    for (const Nanoseconds lasting : {2 * kSecond, 6 * kSecond}) {
      const auto found = drift_coverage({.host = host, .lasting = lasting}, 1'000);
      EXPECT_EQ(found.stated, 1'000);
      EXPECT_NEAR(found.held, 0.95, 0.02) << lasting;
    }
  }
}

TEST(DriftInterval, HoldsTheMeanOfARateThatWanders) {
  const auto found = drift_coverage({.host = JitterProfile::quiet(), .wander = 0.001}, 1'000);
  EXPECT_NEAR(found.held, 0.95, 0.02);
}

TEST(DriftInterval, IsStatedFromTheSixthPointOnAndIsNarrowerWithMore) {
  DriftEstimator drift;
  EXPECT_FALSE(drift.half_width_ppm());
  const auto shortly = drift_coverage({.host = JitterProfile::quiet(), .lasting = 500 * kMillisecond}, 20);
  EXPECT_EQ(shortly.stated, 0);
  const auto early = drift_coverage({.host = JitterProfile::quiet(), .lasting = kSecond}, 20);
  const auto late = drift_coverage({.host = JitterProfile::quiet(), .lasting = 6 * kSecond}, 20);
  EXPECT_EQ(early.stated, 20);
  EXPECT_LT(late.mean_half, early.mean_half / 4);
  EXPECT_LT(late.mean_half, 0.03);
}

TEST(DriftInterval, IsNoneWhereTheRateHasJustBecomeAnother) {
  DriftEstimator drift;
  double place = 0;
  bool none = false;
  for (Nanoseconds time = 0; time < 6 * kSecond; time += kMillisecond) {
    (void)drift.observe(time, time + std::llround(place));
    place += time < 5 * kSecond ? 40 : -60;
    if (time < 5 * kSecond || drift.half_width_ppm()) continue;
    none = true;
  }
  EXPECT_TRUE(none);
}

}  // namespace
}  // namespace syncline::dc
