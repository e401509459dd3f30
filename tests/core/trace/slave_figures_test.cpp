// SPDX-License-Identifier: Apache-2.0
#include "trace/slave_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "channels/cycle_sample.h"
#include "config/network_config.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

/// Four slaves at 1 ms: 0 is the reference clock, 1 and 2 are read in turn, 2 only in the first half, 3 has no clock.
class SlaveFiguresTest : public testing::Test {
 protected:
  void SetUp() override {
    config.slaves.resize(4);
    for (std::size_t i = 0; i < 3; ++i) config.slaves[i].dc.emplace().reference_clock = i == 0;
    std::vector<CycleSample> samples;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      CycleSample sample;
      sample.cycle = i;
      sample.send_time = static_cast<Nanoseconds>(i) * kMillisecond;
      sample.flags = CycleSample::kSlaveFollows;
      sample.slave_position = static_cast<std::int16_t>(1 + i % 2);
      if (sample.slave_position == 2 && i >= 500) sample.slave_position = -1;
      sample.slave_deviation_ns = i == 600 ? -300 : i % 4 < 2 ? 10 : -30;
      if (i % 250 == 0) {
        sample.sm2_position = 2;
        sample.slave_sm2_missed = static_cast<std::uint32_t>(i / 250) * 3;
      }
      samples.push_back(sample);
    }
    store.append(samples);
  }
  const SlaveFigures& of(std::size_t slave, Nanoseconds begin, Nanoseconds end, double limit = 100) {
    round.aim(store, begin, end, limit);
    EXPECT_TRUE(round.work(1'000'000));
    return round.figures().at(slave);
  }

  NetworkConfig config;
  SampleStore store{{.slaves = 4}};
  SlaveFigureRound round;
};

TEST_F(SlaveFiguresTest, EveryReadingOfTheStretchCounts) {
  const auto& figures = of(1, 0, kSecond);
  EXPECT_EQ(figures.statistics.count(), 500U);
  EXPECT_EQ(figures.statistics.max_magnitude(), 300);
  EXPECT_NEAR(figures.statistics.mean(), (249 * 10 - 250 * 30 - 300) / 500.0, 1e-9);
  EXPECT_NEAR(figures.statistics.rms(), std::sqrt((249 * 100 + 250 * 900 + 90'000) / 500.0), 1e-9);
  EXPECT_EQ(figures.over, 1U);
  EXPECT_DOUBLE_EQ(*figures.share_over(100), 1 / 500.0);
  EXPECT_FALSE(figures.share_over(0).has_value()) << "without a limit nothing is over it";
  EXPECT_EQ(of(1, 0, 600 * kMillisecond).statistics.max_magnitude(), 30) << "its end is not of it";
}

TEST_F(SlaveFiguresTest, WhoIsNotReadAnyMoreHasNoPresentValue) {
  const auto& figures = of(2, 0, kSecond);
  ASSERT_TRUE(figures.newest);
  EXPECT_EQ(figures.newest->time, 499 * kMillisecond);
  EXPECT_EQ(figures.age, 500 * kMillisecond);
  EXPECT_FALSE(figures.is_present);
  EXPECT_TRUE(of(2, 0, 505 * kMillisecond).is_present);
  EXPECT_TRUE(of(1, 0, 10 * kSecond).is_present) << "behind the newest cycle there is no present";
  EXPECT_FALSE(of(3, 0, kSecond).newest);
}

TEST_F(SlaveFiguresTest, MissedEventsAreThoseOfTheStretch) {
  EXPECT_EQ(of(2, 0, kSecond).missed, 9U);
  EXPECT_EQ(of(2, 300 * kMillisecond, kSecond).missed, 6U);
  EXPECT_EQ(of(2, 800 * kMillisecond, kSecond).missed, 0U);
  EXPECT_FALSE(of(1, 0, kSecond).missed);
}

TEST_F(SlaveFiguresTest, ARoundGoesOnWhereItWas) {
  round.aim(store, 0, kSecond, 100);
  EXPECT_FALSE(round.work(1));
  EXPECT_EQ(round.figures()[1].statistics.count(), 0U);
  EXPECT_FALSE(round.work(1));
  EXPECT_EQ(round.figures()[1].statistics.count(), 500U);
  EXPECT_TRUE(round.work(1'000'000));
  round.aim(store, 0, kSecond / 2, 100);
  EXPECT_FALSE(round.complete());
  EXPECT_EQ(round.figures()[1].statistics.count(), 500U) << "those of before stay until then";
}

TEST_F(SlaveFiguresTest, KnowsTheReferenceClockAndWhoHasNone) {
  using enum ClockRole;
  EXPECT_THAT(clock_roles(config, store, -1), testing::ElementsAre(kReference, kFollower, kFollower, kNoDc));
  EXPECT_THAT(clock_roles(config, store, 3), testing::ElementsAre(kFollower, kFollower, kFollower, kReference))
      << "that which runs";
  EXPECT_EQ(clock_roles(config, store, 1)[1], kFollower) << "it was read as one";
}

}  // namespace
}  // namespace syncline
