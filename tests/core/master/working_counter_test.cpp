// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/working_counter.h"

#include <gtest/gtest.h>

#include <vector>

#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "master/exchange/run_state.h"

namespace syncline {
namespace {

class WorkingCounterTest : public ::testing::Test {
 protected:
  WorkingCounterTest() {
    run.snapshot.slaves[0].present = true;
    counter.set_judging(true);
  }
  void cycles(int count, std::uint16_t received) {
    for (int i = 0; i < count; ++i) {
      CycleSample sample;
      counter.observe(3, received, now += kMillisecond, sample);
    }
  }
  std::vector<Event> told() { return channels.events.drain(); }

  NetworkConfig config = [] {
    NetworkConfig one;
    one.slaves.resize(1);
    return one;
  }();
  MasterChannels channels;
  RunState run{config, channels};
  WorkingCounter counter{run.snapshot, run.states, run.teller};
  Nanoseconds now = 0;
};

TEST_F(WorkingCounterTest, ASpellIsToldWhenItBeginsAndWithItsCountWhenItEnds) {
  cycles(5, 0);
  cycles(1, 3);
  const auto events = told();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].time, kMillisecond);
  EXPECT_EQ(events[0].as<events::WkcError>()->count, 1U);
  EXPECT_EQ(events[1].time, 6 * kMillisecond);
  EXPECT_EQ(events[1].as<events::WkcError>()->count, 5U);
}

TEST_F(WorkingCounterTest, ASpellEndsWithJudgingAndDoesNotLastThroughThePause) {
  cycles(5, 0);
  counter.set_judging(false);
  const auto before = told();
  ASSERT_EQ(before.size(), 2U);
  EXPECT_EQ(before[1].time, 5 * kMillisecond);
  EXPECT_EQ(before[1].as<events::WkcError>()->count, 5U);

  cycles(60'000, 0);
  counter.set_judging(true);
  cycles(1, 3);
  EXPECT_TRUE(told().empty());
  cycles(2, 1);  // another spell, which begins with a word of its own
  cycles(1, 3);
  const auto after = told();
  ASSERT_EQ(after.size(), 2U);
  EXPECT_EQ(after[0].as<events::WkcError>()->count, 1U);
  EXPECT_EQ(after[1].as<events::WkcError>()->count, 2U);
  EXPECT_EQ(run.snapshot.wkc_errors, 7U);
}

TEST_F(WorkingCounterTest, ASpellEndsWhereNothingCanBeReceived) {
  cycles(4, 0);
  counter.pause();
  now += 5 * kSecond;
  cycles(1, 0);
  const auto events = told();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1].as<events::WkcError>()->count, 4U);
  EXPECT_EQ(events[1].time, 4 * kMillisecond);
  EXPECT_EQ(events[2].as<events::WkcError>()->count, 1U);
}

TEST_F(WorkingCounterTest, JudgingThatGoesOnEndsNoSpell) {
  cycles(3, 0);
  counter.set_judging(true);
  cycles(3, 0);
  cycles(1, 3);
  const auto events = told();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].as<events::WkcError>()->count, 6U);
}

}  // namespace
}  // namespace syncline
