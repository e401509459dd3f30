// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/clock_step_detector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random.h"

namespace syncline::dc {
namespace {

constexpr Nanoseconds kLimit = 4'000;

/// A reference clock that is `ppm` faster, read once a cycle with a stamp's noise.
class Readings {
 public:
  explicit Readings(double ppm, double noise = 0) : ppm_(ppm), noise_(noise) {}
  /// `doubt`: by how much the frame came back later than frames can.
  std::optional<Nanoseconds> read(Nanoseconds stamp_error = 0, Nanoseconds doubt = 0) {
    time_ += kMillisecond;
    const auto drift = static_cast<Nanoseconds>(std::llround(static_cast<double>(time_) * ppm_ * 1e-6));
    const auto wrong = static_cast<Nanoseconds>(std::llround(noise_ * std::abs(random_.normal())));
    const auto reading = detector_.observe(time_, time_ + drift + stepped_ + wrong + stamp_error, doubt);
    doubtful += reading.doubt > 0 ? 1 : 0;
    return reading.step;
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      if (const auto step = read()) steps.push_back(*step);
    }
  }
  void step(Nanoseconds by) { stepped_ += by; }
  std::vector<Nanoseconds> steps;
  int doubtful = 0;

 private:
  ClockStepDetector detector_{kLimit};
  double ppm_, noise_;
  Random random_{3};
  Nanoseconds time_ = 700 * kSecond, stepped_ = 0;
};

TEST(ClockStepDetector, SeesAStepInTheThirdReadingAlsoByWholeCycles) {
  for (const double ppm : {-700.0, -40.0, 0.0, 90.0, 700.0}) {
    for (const Nanoseconds step :
         {Nanoseconds{6'000}, -20'000 * Nanoseconds{1}, kMillisecond, -3 * kMillisecond, kSecond}) {
      Readings readings(ppm, 300);
      readings.run(2'000);
      EXPECT_TRUE(readings.steps.empty()) << ppm;
      readings.step(step);
      readings.run(3);
      ASSERT_EQ(readings.steps.size(), 1U) << ppm << " " << step;
      EXPECT_NEAR(static_cast<double>(readings.steps.front()), static_cast<double>(step), 1'500);
      readings.run(2'000);
      EXPECT_EQ(readings.steps.size(), 1U) << "told once";
    }
  }
}

TEST(ClockStepDetector, WrongStampsAreNoSteps) {
  Readings readings(30, 500);
  Random random(9);
  readings.run(500);
  for (int i = 0; i < 20'000; ++i) {
    const bool tail = random.uniform() < 0.02;
    if (const auto step = readings.read(tail ? static_cast<Nanoseconds>(random.uniform() * 72'000) : 0)) {
      readings.steps.push_back(*step);
    }
  }
  EXPECT_TRUE(readings.steps.empty());
}

/// Whoever measures how much later frames come gets used to it, and says less and less.
TEST(ClockStepDetector, WhatBeganAsAHeldFrameStaysOneWhileItIsAsLate) {
  Readings readings(30);
  readings.run(500);
  EXPECT_FALSE(readings.read(30'000, 30'000));
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(readings.read(30'000, 16'000)) << i;
  EXPECT_FALSE(readings.read(30'000, 14'000));
  EXPECT_FALSE(readings.read(30'000, 14'000));
  EXPECT_TRUE(readings.read(30'000, 14'000)) << "more than twice as late as the frame explains";
  // Another lateness is no longer the same frame's.
  Readings other(30);
  other.run(500);
  EXPECT_FALSE(other.read(30'000, 30'000));
  EXPECT_FALSE(other.read(40'000, 21'000));
  EXPECT_FALSE(other.read(40'000, 21'000));
  EXPECT_TRUE(other.read(40'000, 21'000));
}

TEST(ClockStepDetector, WrongStampsThatAgreeAreNoStepWhereTheirFramesCameBackLate) {
  Readings readings(30, 300);
  readings.run(500);
  for (const Nanoseconds late : {9'800, 7'900, 8'800, 9'100, 8'600, 9'000}) EXPECT_FALSE(readings.read(late, late));
  EXPECT_EQ(readings.doubtful, 6);
  readings.run(2'000);
  EXPECT_EQ(readings.doubtful, 6);
  EXPECT_TRUE(readings.steps.empty());
}

/// As behind those of another program on the host: each within the limit, and for a while.
TEST(ClockStepDetector, FramesThatWaitedForAWhileAreNoStepWhenTheyNoLongerDo) {
  for (const Nanoseconds late : {1'500, 2'500, 3'500}) {
    for (const int cycles : {20, 60, 100, 300}) {
      Readings readings(30, 300);
      readings.run(500);
      for (int i = 0; i < cycles; ++i) {
        if (const auto step = readings.read(late, late + 200)) readings.steps.push_back(*step);
      }
      readings.run(500);
      EXPECT_TRUE(readings.steps.empty()) << late << " for " << cycles;
      readings.step(-6'000);
      readings.run(3);
      EXPECT_EQ(readings.steps.size(), 1U) << late << " for " << cycles;
    }
  }
}

TEST(ClockStepDetector, AFrameThatComesBackLateHidesNoStep) {
  for (const Nanoseconds step : {-9'000, 9'000, 200'000}) {
    Readings readings(30, 300);
    readings.run(500);
    readings.step(step);
    for (int i = 0; i < 5; ++i) {
      if (const auto found = readings.read(0, 5'500)) readings.steps.push_back(*found);
    }
    readings.run(3);
    ASSERT_EQ(readings.steps.size(), 1U) << step;
    EXPECT_NEAR(static_cast<double>(readings.steps.front()), static_cast<double>(step), 1'500);
  }
}

/// Nor is it taken for the same that was held up a while before.
TEST(ClockStepDetector, AStepAsLargeAsAFrameWasLateBeforeIsOne) {
  Readings readings(30, 300);
  readings.run(500);
  EXPECT_FALSE(readings.read(20'000, 20'000));
  readings.run(10);
  readings.step(20'000);
  for (int i = 0; i < 3; ++i) {
    if (const auto found = readings.read(0, 11'000)) readings.steps.push_back(*found);
  }
  EXPECT_EQ(readings.steps.size(), 1U);
}

/// A line of few readings would be drawn away by it, and all readings behind it would seem to have stepped.
TEST(ClockStepDetector, AFrameThatWasHeldUpDoesNotSpoilALineThatIsYoung) {
  for (const int first : {0, 1, 10, 30, 45, 49}) {
    SCOPED_TRACE(first);
    Readings readings(40, 300);
    readings.run(first);
    EXPECT_FALSE(readings.read(58'000, 58'300));
    readings.run(2'000);
    EXPECT_TRUE(readings.steps.empty());
    readings.step(8'000);
    readings.run(3);
    EXPECT_EQ(readings.steps.size(), 1U);
  }
  // Where all are, they are what there is.
  Readings readings(40, 300);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(readings.read(20'000, 20'300));
  EXPECT_FALSE(readings.read(-8'000));
  EXPECT_FALSE(readings.read(-8'000));
  EXPECT_TRUE(readings.read(-8'000));
}

TEST(ClockStepDetector, AHostWhoseStampsAreAlwaysThatBadIsNotAccused) {
  Readings readings(30, 12'000);
  readings.run(20'000);
  EXPECT_TRUE(readings.steps.empty());
}

TEST(ClockStepDetector, AStepWithinTheLimitIsNone) {
  Readings readings(30, 100);
  readings.run(500);
  readings.step(3'000);
  readings.run(500);
  EXPECT_TRUE(readings.steps.empty());
}

}  // namespace
}  // namespace syncline::dc
