// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/loop_tuning.h"

#include <gtest/gtest.h>

#include <cmath>

#include "channels/snapshot.h"
#include "config/network_config.h"
#include "tests/support/simulated_segment.h"

namespace syncline {
namespace {

/// A terminal whose quartz is 30 ppm fast, and which has learned to run as fast as who tells it the time.
class LoopTuningTest : public ::testing::Test {
 protected:
  VirtualClock clock;
  test::SimulatedSegment segment{clock, [] {
                                   auto sim = test::terminals(1);
                                   sim.slaves[0].oscillator.ppm = 30;
                                   return sim;
                                 }()};
  FrameExchange exchange{segment, clock};
  NetworkConfig config;
  Snapshot snapshot;

  void SetUp() override {
    test::give_addresses(segment, 1);
    config.slaves.resize(1);
    config.slaves[0].station_address = 1001;
    snapshot.slaves.resize(1);
    snapshot.slaves[0].present = true;
    segment.set<std::uint8_t>(0, reg::kFilterDepthDifference, kDepth);
    segment.set<std::uint8_t>(0, reg::kFilterDepthSpeedCounter, 8);
    segment.set<std::uint16_t>(0, reg::kSpeedCounterStart, 1'000);
    offset_ = static_cast<std::int64_t>(time()) - clock.now();
    for (int i = 0; i < 4'000; ++i) tell(0);
  }
  /// One time, that much too late.
  void tell(Nanoseconds wrong) {
    clock.advance_to(clock.now() + kMillisecond);
    segment.set(0, reg::kSystemTime, static_cast<std::uint32_t>(clock.now() + offset_ + wrong));
  }
  [[nodiscard]] std::uint64_t time() {
    segment.set<std::uint8_t>(0, reg::kUserRam, 0);  // a frame that says how late it is
    return segment.get<std::uint64_t>(0, reg::kSystemTime);
  }
  /// Of the clock against who told it the time, when nobody does any more.
  [[nodiscard]] double ppm() {
    const auto before = static_cast<std::int64_t>(time()) - clock.now();
    clock.advance_to(clock.now() + kSecond);
    const auto after = static_cast<std::int64_t>(time()) - clock.now();
    return static_cast<double>(after - before) * 1e-3;
  }
  [[nodiscard]] int depth() { return segment.get<std::uint8_t>(0, reg::kFilterDepthDifference); }
  void run(LoopTuning& tuning, int steps) {
    for (int i = 0; i < steps && tuning.pending(); ++i)
      ASSERT_TRUE(tuning.step(exchange, clock.now() + 100 * kMicrosecond));
  }

  static constexpr int kDepth = 1;

 private:
  std::int64_t offset_ = 0;
};

TEST_F(LoopTuningTest, WithoutItAClockRunsOnWithTheLastMessage) {
  EXPECT_NEAR(ppm(), 0, 1);
  for (int i = 0; i < 4'000; ++i) tell(0);
  tell(-5'000);
  EXPECT_GT(std::abs(ppm()), 100);
}

TEST_F(LoopTuningTest, SettledItRunsOnAsItHasLearned) {
  tell(-5'000);
  tell(5'000);
  LoopTuning tuning(config, snapshot);
  EXPECT_FALSE(tuning.pending());
  tuning.settle(0);
  run(tuning, 4);
  EXPECT_FALSE(tuning.pending());
  EXPECT_NEAR(ppm(), 0, 2);
  EXPECT_EQ(depth(), kDepth) << "as it was";
}

TEST_F(LoopTuningTest, SettledItMayAverageOtherwiseAfterwards) {
  tell(5'000);
  LoopTuning tuning(config, snapshot);
  tuning.settle(0, std::uint8_t{6});
  run(tuning, 3);
  EXPECT_FALSE(tuning.pending());
  EXPECT_EQ(depth(), 6);
  EXPECT_LT(std::abs(ppm()), 10);
  tuning.set_depth(0, 0);
  run(tuning, 1);
  EXPECT_FALSE(tuning.pending());
  EXPECT_EQ(depth(), 0);
}

/// Whichever frame is lost, and whenever it is asked for once more: no depth is lost with it.
TEST_F(LoopTuningTest, WhatIsLostIsRepeated) {
  for (const int lost : {0, 1, 2, 3}) {
    for (const bool again : {false, true}) {
      tell(5'000);
      LoopTuning tuning(config, snapshot);
      tuning.settle(0);
      run(tuning, lost);
      segment.lose(1);
      run(tuning, 1);
      EXPECT_TRUE(tuning.pending()) << lost;
      if (again) tuning.settle(0);
      run(tuning, 8);
      EXPECT_FALSE(tuning.pending()) << lost;
      EXPECT_EQ(depth(), kDepth) << lost;
      EXPECT_LT(std::abs(ppm()), 10) << lost;
    }
  }
}

/// A slave that went in between is told the rest when it is back.
TEST_F(LoopTuningTest, WhoIsAwayIsWaitedFor) {
  LoopTuning tuning(config, snapshot);
  tuning.settle(0);
  run(tuning, 2);
  EXPECT_EQ(depth(), 15) << "holding";
  snapshot.slaves[0].present = false;
  EXPECT_FALSE(tuning.pending());
  const auto sent = segment.frames_sent;
  ASSERT_TRUE(tuning.step(exchange, clock.now() + 100 * kMicrosecond));
  EXPECT_EQ(segment.frames_sent, sent);
  snapshot.slaves[0].present = true;
  run(tuning, 2);
  EXPECT_EQ(depth(), kDepth);
}

TEST_F(LoopTuningTest, WhoNeverAnswersIsGivenUp) {
  LoopTuning tuning(config, snapshot);
  config.slaves[0].station_address = 77;
  tuning.settle(0);
  run(tuning, 999);
  EXPECT_TRUE(tuning.pending());
  run(tuning, 1);
  EXPECT_FALSE(tuning.pending());
}

}  // namespace
}  // namespace syncline
