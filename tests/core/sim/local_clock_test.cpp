// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/local_clock.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "sim/dc/correction_rates.h"
#include "sim/dc/time_control_loop.h"
#include "support/clock.h"
#include "support/random.h"

namespace syncline::test {
namespace {

constexpr auto kStart = VirtualClock::kDefaultStart;

RC_GTEST_PROP(SimLocalClock, TimeOfIsTheFirstTimeThatShowsIt, ()) {
  OscillatorConfig config;
  config.ppm = *rc::gen::inRange(-200'000, 200'000) * 0.1;
  config.start_offset = *rc::gen::inRange<Nanoseconds>(0, 1'000'000'000'000);
  sim::LocalClock clock(config, kStart, 1);
  clock.set_correction(*rc::gen::inRange(-770, 770) * 1e-6, kStart + 3 * kMillisecond);
  const auto ahead = std::uint64_t{1} << *rc::gen::inRange(0, 62);
  const auto wanted = clock.exact(kStart + 3 * kMillisecond) + ahead + *rc::gen::inRange<std::uint64_t>(0, ahead);
  const auto time = clock.time_of(wanted, kStart + 3 * kMillisecond);
  RC_ASSERT(time > kStart);
  if (time == sim::LocalClock::kNever) {
    RC_ASSERT(ahead > std::uint64_t{1} << 60);
  } else {
    RC_ASSERT(static_cast<std::int64_t>(clock.exact(time) - wanted) >= 0);
    RC_ASSERT(static_cast<std::int64_t>(clock.exact(time - 1) - wanted) < 0);
  }
}

RC_GTEST_PROP(SimLocalClock, TimeBeforeIsWhatTimeOfSaidBefore, ()) {
  OscillatorConfig config;
  config.ppm = *rc::gen::inRange(-50'000, 50'000) * 0.1;
  config.start_offset = *rc::gen::inRange<Nanoseconds>(0, 1'000'000'000'000);
  sim::LocalClock clock(config, kStart, 1);
  const auto from = kStart + 3 * kMillisecond;
  clock.set_correction(*rc::gen::inRange(-770, 770) * 1e-6, from);
  const auto wanted = clock.exact(from) + *rc::gen::inRange<std::uint64_t>(1, 10'000'000);
  const auto time = clock.time_of(wanted, from);
  const auto moment = clock.moment(time + *rc::gen::inRange<Nanoseconds>(0, 10'000'000));
  clock.set_correction(*rc::gen::inRange(-770, 770) * 1e-6, moment.time);  // what comes later does not matter
  RC_ASSERT(sim::LocalClock::time_before(moment, wanted) == time);
}

TEST(SimLocalClock, WhatIsPastIsDueNowAndWhatTheCounterCannotReachNever) {
  sim::LocalClock clock({}, kStart, 1);
  EXPECT_EQ(clock.time_of(clock.exact(kStart) - 1, kStart), kStart);
  EXPECT_EQ(clock.time_of(clock.exact(kStart) + (std::uint64_t{1} << 63), kStart), kStart)
      << "half a turn away is past";
  EXPECT_EQ(clock.time_of(0x7FFF'FFFF'FFFF'FFFF, kStart), sim::LocalClock::kNever);
  EXPECT_EQ(clock.time_of(1'000, kStart), kStart + 1'000);
}

TEST(SimLocalClock, CommittingOftenOrNeverShowsTheSame) {
  OscillatorConfig config;
  config.ppm = 33.333;
  sim::LocalClock seldom(config, kStart, 1), often(config, kStart, 1);
  for (int i = 1; i <= 10'000; ++i) often.set_correction(0, kStart + i * 12'345);
  const auto time = kStart + 86'400 * kSecond;
  EXPECT_EQ(seldom.exact(time), often.exact(time));
  EXPECT_EQ(seldom.sample(time), often.sample(time));
}

TEST(SimLocalClock, TwoHundredYearsPassAtOnce) {
  OscillatorConfig config;
  config.ppm = 20;
  config.wander_ppm = 5;
  config.changes = {{kStart + kSecond, INT64_MAX, 10}};  // warms up for ever
  sim::LocalClock clock(config, kStart, 1);
  const auto time = kStart + 200LL * 365 * 86'400 * kSecond;
  EXPECT_TRUE(clock.advance_to(time));
  const auto gained = static_cast<double>(clock.exact(time)) - static_cast<double>(time - kStart);
  EXPECT_GT(gained, 0);
  EXPECT_LT(gained, 40e-6 * static_cast<double>(time - kStart));
}

/// What is remembered is what would be found anew, whatever was asked before.
TEST(SimLocalClock, KnowsTheRatesOfTheLoop) {
  sim::TimeControlLoop loop;
  Random random(7);
  for (int i = 0; i < 5'000; ++i) {
    if (random.next() % 500 == 0) {
      loop.set_speed_counter_start(static_cast<std::uint16_t>(0x0080 + random.next() % 0x3F00));
      loop.set_filter_depth_speed_counter(static_cast<std::uint8_t>(random.next() % 13));
    }
    (void)loop.observe(static_cast<std::int32_t>(random.next() % 2'001) - 1'000);
    ASSERT_EQ(sim::correction_rate(loop), sim::LocalClock::rate_of(loop.correction())) << i;
    ASSERT_EQ(sim::correction_rate(loop), sim::LocalClock::rate_of(loop.correction())) << "the second time, " << i;
  }
}

}  // namespace
}  // namespace syncline::test
