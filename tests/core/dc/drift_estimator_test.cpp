// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/drift_estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace syncline::dc {
namespace {

/// Half of the stamps are nearly right, the others too early by a one-sided noise with a long tail.
class Host {
 public:
  explicit Host(double noise, double tail_probability = 0.001, double tail = 72'000)
      : noise_(noise), tail_probability_(tail_probability), tail_(tail) {}
  void run(DriftEstimator& drift, Nanoseconds duration, double ppm, Nanoseconds cycle = kMillisecond) {
    for (const auto end = time_ + duration; time_ < end; time_ += cycle) {
      const double wrong =
          std::abs(random_.normal()) * noise_ + (random_.uniform() < tail_probability_ ? random_.uniform() * tail_ : 0);
      (void)drift.observe(time_, time_ + std::llround(reference_ + wrong));
      reference_ += static_cast<double>(cycle) * ppm * 1e-6;
    }
  }
  void step(double ns) { reference_ += ns; }

 private:
  double noise_, tail_probability_, tail_, reference_ = 0;
  Random random_{11};
  Nanoseconds time_ = 5 * kSecond;
};

TEST(DriftEstimator, IsTrueWithinATenthOfAPpmOnHostsWithTails) {
  for (const double noise : {0.0, 100.0, 500.0, 3'300.0}) {
    for (const double ppm : {-90.0, -0.3, 12.5, 85.0, 700.0}) {
      for (const Nanoseconds cycle : {125'000, 1'000'000, 10'000'000}) {
        DriftEstimator drift;
        Host host(noise);
        host.run(drift, 30 * kSecond, ppm, cycle);
        EXPECT_NEAR(drift.ppm(), ppm, noise < 1'000 ? 0.1 : 0.5) << noise << " " << cycle;
      }
    }
  }
}

TEST(DriftEstimator, AStepOfTheClockDoesNotSpoilIt) {
  for (const double step : {-1e9, -50e3, 20e3, 1e6}) {
    DriftEstimator drift;
    Host host(200);
    host.run(drift, 10 * kSecond + 37 * kMillisecond, 40);
    for (int i = 0; i < 30; ++i) {
      if (i % 10 == 0) host.step(step);
      host.run(drift, 100 * kMillisecond, 40);
      ASSERT_NEAR(drift.ppm(), 40, 0.5) << step << " " << i;
    }
  }
}

TEST(DriftEstimator, FollowsANewRateWithinHalfASecond) {
  DriftEstimator drift;
  Host host(200);
  host.run(drift, 10 * kSecond, 40);
  host.run(drift, 500 * kMillisecond, -60);
  EXPECT_NEAR(drift.ppm(), -60, 5);
}

TEST(DriftEstimator, FollowsAQuartzThatWarmsUp) {
  DriftEstimator drift;
  Host host(200);
  double ppm = 0;
  for (int i = 0; i < 200; ++i, ppm += 0.01) host.run(drift, 100 * kMillisecond, ppm);
  EXPECT_NEAR(drift.ppm(), ppm, 0.4);
}

}  // namespace
}  // namespace syncline::dc
