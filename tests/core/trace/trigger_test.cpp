// SPDX-License-Identifier: Apache-2.0
#include "trace/trigger.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "findings/finding.h"
#include "trace/sample_store.h"

namespace syncline {
namespace {

constexpr Nanoseconds kTriggerStart = 1000 * kSecond;

Nanoseconds triggered_at(std::uint64_t cycle) { return kTriggerStart + static_cast<Nanoseconds>(cycle) * kMillisecond; }

CycleSample trigger_sample(std::uint64_t cycle, std::int32_t error) {
  CycleSample sample;
  sample.cycle = cycle;
  sample.send_time = triggered_at(cycle);
  sample.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
  sample.dcm_error_ns = error;
  return sample;
}

/// Errors of cycles 0, 1, 2 ...
std::vector<CycleSample> trigger_samples(const std::vector<std::int32_t>& errors) {
  std::vector<CycleSample> all;
  for (const auto error : errors) all.push_back(trigger_sample(all.size(), error));
  return all;
}

SampleStore trigger_store(const std::vector<CycleSample>& samples) {
  SampleStore store({.slaves = 2});
  store.append(samples);
  return store;
}

Trigger level_trigger(double level, Trigger::Edge edge = Trigger::Edge::kUp) {
  Trigger trigger;
  trigger.signal = Signal::kDcmError;
  trigger.level = level;
  trigger.edge = edge;
  trigger.hold_off = 0;
  trigger.pre = 2 * kMillisecond;
  trigger.post = 3 * kMillisecond;
  return trigger;
}

std::vector<std::uint64_t> trigger_cycles(const Trigger& trigger, const SampleStore& store) {
  TriggerWatch watch(trigger);
  EXPECT_TRUE(watch.look(store));
  std::vector<std::uint64_t> cycles;
  for (const auto& episode : watch.episodes()) cycles.push_back(episode.cycle.value_or(9999));
  return cycles;
}
using TriggerCycles = std::vector<std::uint64_t>;

TEST(TriggerWatch, FindsTheCycleInWhichALevelIsCrossed) {
  const auto store = trigger_store(trigger_samples({0, 50, 100, 150, 90, 99, 101, -5}));
  EXPECT_EQ(trigger_cycles(level_trigger(100), store), (TriggerCycles{2, 6}));
  EXPECT_EQ(trigger_cycles(level_trigger(100, Trigger::Edge::kDown), store), (TriggerCycles{4, 7}));
  EXPECT_EQ(trigger_cycles(level_trigger(100, Trigger::Edge::kEither), store), (TriggerCycles{2, 4, 6, 7}));
  TriggerWatch watch(level_trigger(100));
  watch.look(store);
  const auto& episode = watch.episodes().front();
  EXPECT_EQ(episode.time, triggered_at(2));
  EXPECT_EQ(episode.value, 100);
  EXPECT_EQ(episode.from, triggered_at(0));
  EXPECT_EQ(episode.to, triggered_at(5));
}

TEST(TriggerWatch, TakesTheAbsoluteValueWhereItIsAsked) {
  const auto store = trigger_store(trigger_samples({0, -120, 0, 120}));
  auto trigger = level_trigger(100);
  EXPECT_EQ(trigger_cycles(trigger, store), (TriggerCycles{3}));
  trigger.magnitude = true;
  EXPECT_EQ(trigger_cycles(trigger, store), (TriggerCycles{1, 3}));
}

TEST(TriggerWatch, FindsWhereABandIsLeftAndEntered) {
  auto trigger = level_trigger(0);
  trigger.kind = Trigger::Kind::kWindow;
  trigger.low = -10;
  trigger.high = 10;
  const auto store = trigger_store(trigger_samples({0, 10, 11, -20, -10, -11, 0}));
  EXPECT_EQ(trigger_cycles(trigger, store), (TriggerCycles{2, 5}));
  trigger.enters = true;
  EXPECT_EQ(trigger_cycles(trigger, store), (TriggerCycles{4, 6}));
}

TEST(TriggerWatch, NothingIsCrossedInAGap) {
  auto samples = trigger_samples({0, 0, 200, 0, 200});
  samples[1].flags = CycleSample::kDcmActive;  // without a value
  EXPECT_EQ(trigger_cycles(level_trigger(100), trigger_store(samples)), (TriggerCycles{4}));
  samples = trigger_samples({0, 200, 0, 200});
  for (std::size_t i = 1; i < samples.size(); ++i) {
    samples[i].cycle += 7;  // the ring was overrun
    samples[i].send_time += 7 * kMillisecond;
  }
  EXPECT_EQ(trigger_cycles(level_trigger(100), trigger_store(samples)), (TriggerCycles{10}))
      << "and the cycle has its own number";
  EXPECT_TRUE(trigger_cycles(level_trigger(100), trigger_store(trigger_samples({200, 200}))).empty())
      << "what was above before anybody looked has crossed nothing";
}

TEST(TriggerWatch, HoldsOffAndCountsWhatItLeavesOut) {
  std::vector<std::int32_t> errors;
  for (int i = 0; i < 100; ++i) errors.push_back(i % 10 == 5 ? 200 : 0);
  const auto store = trigger_store(trigger_samples(errors));
  auto trigger = level_trigger(100);
  trigger.hold_off = 30 * kMillisecond;
  TriggerWatch watch(trigger);
  watch.look(store);
  EXPECT_EQ(trigger_cycles(trigger, store), (TriggerCycles{5, 35, 65, 95}));
  EXPECT_EQ(watch.episodes().front().left_out, 2U);
  EXPECT_EQ(watch.left_out(), 6U);
  for (std::size_t i = 1; i < watch.episodes().size(); ++i) {
    EXPECT_GE(watch.episodes()[i].time - watch.episodes()[i - 1].time, trigger.hold_off);
  }
}

TEST(TriggerWatch, KeepsTheLatestWhereEachCycleIsOne) {
  std::vector<std::int32_t> errors;
  for (int i = 0; i < 2000; ++i) errors.push_back(i % 2 == 0 ? 0 : 200);
  const auto store = trigger_store(trigger_samples(errors));
  TriggerWatch whole(level_trigger(100)), portions(level_trigger(100));
  EXPECT_TRUE(whole.look(store));
  while (!portions.look(store, 7 * kMillisecond)) {
  }
  EXPECT_EQ(whole.count(), 1000U);
  EXPECT_EQ(whole.episodes().size(), 1000 - 6 * TriggerWatch::kMostEpisodes / 2) << "the earlier half went six times";
  EXPECT_EQ(whole.episodes().back().cycle, 1999U);
  EXPECT_EQ(portions.episodes(), whole.episodes());
}

TEST(TriggerWatch, ASingleOneEndsWithItsFirstEpisode) {
  const auto store = trigger_store(trigger_samples({0, 200, 0, 200}));
  auto trigger = level_trigger(100);
  trigger.mode = Trigger::Mode::kSingle;
  TriggerWatch watch(trigger);
  watch.look(store);
  ASSERT_EQ(watch.episodes().size(), 1U);
  EXPECT_TRUE(watch.done());
  EXPECT_EQ(watch.left_out(), 0U);
  TriggerWatch later(trigger, triggered_at(2));
  later.look(store);
  ASSERT_EQ(later.episodes().size(), 1U);
  EXPECT_EQ(later.episodes().front().cycle, 3U) << "armed again it waits for the next one";
}

TEST(TriggerWatch, TakesEventsOfAnySlaveOrOfOne) {
  const auto store = trigger_store(trigger_samples(std::vector<std::int32_t>(50, 0)));
  Trigger trigger;
  trigger.kind = Trigger::Kind::kEvent;
  trigger.code = "event-slave-lost";
  trigger.hold_off = 0;
  const std::vector<Event> events{{triggered_at(10) + 5, 0, events::SlaveLost{}},
                                  {triggered_at(20), 1, events::SlaveFound{}},
                                  {triggered_at(30), 1, events::SlaveLost{}}};
  TriggerWatch any(trigger);
  trigger.slave = 1;
  TriggerWatch one(trigger);
  for (const auto& event : events) {
    any.hear(event, store);
    one.hear(event, store);
  }
  ASSERT_EQ(any.episodes().size(), 2U);
  EXPECT_EQ(any.episodes()[0].cycle, 10U);
  EXPECT_EQ(any.episodes()[0].slave, 0);
  ASSERT_EQ(one.episodes().size(), 1U);
  EXPECT_EQ(one.episodes()[0].time, triggered_at(30));
}

TEST(TriggerWatch, CountsOfASlaveHoldUntilTheirNextChange) {
  std::vector<CycleSample> samples;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    samples.push_back(trigger_sample(i, 0));
    samples.back().sm2_position = 1;
    samples.back().slave_sm2_missed = i < 2500 ? 4 : 5;
  }
  auto trigger = level_trigger(5);
  trigger.signal = Signal::kSm2Missed;
  trigger.slave = 1;
  EXPECT_EQ(trigger_cycles(trigger, trigger_store(samples)), (TriggerCycles{2500}));
  trigger.slave = 7;
  EXPECT_TRUE(trigger_cycles(trigger, trigger_store(samples)).empty()) << "there is no such slave";
}

TEST(TriggerWatch, FindsTheSameWhileItRunsAndAfterwards) {
  std::vector<std::int32_t> errors;
  for (int i = 0; i < 20'000; ++i) errors.push_back(i * 7919 % 400 - 200);
  auto samples = trigger_samples(errors);
  for (std::size_t i = 0; i < samples.size(); i += 97) samples[i].flags = CycleSample::kFrameLost;
  auto trigger = level_trigger(190);
  trigger.hold_off = 17 * kMillisecond;
  SampleStore live({.slaves = 2});
  TriggerWatch alive(trigger);
  for (std::size_t i = 0; i < samples.size(); i += 33) {
    const auto count = std::min<std::size_t>(33, samples.size() - i);
    live.append(std::span(samples).subspan(i, count));
    EXPECT_TRUE(alive.look(live));
  }
  const auto whole = trigger_store(samples);
  TriggerWatch replayed(trigger);
  int portions = 1;
  while (!replayed.look(whole, 701 * kMillisecond)) ++portions;
  EXPECT_GT(portions, 20);
  EXPECT_GT(alive.episodes().size(), 200U);
  EXPECT_EQ(alive.episodes(), replayed.episodes());
}

TEST(TriggerWatch, SaysWhereItIs) {
  using State = TriggerWatch::State;
  auto trigger = level_trigger(100);
  trigger.hold_off = 20 * kMillisecond;
  const auto store = trigger_store(trigger_samples({0, 0, 0, 0, 0, 200}));
  TriggerWatch watch(trigger);
  EXPECT_EQ(watch.state(triggered_at(0), triggered_at(1)), State::kFilling);
  EXPECT_EQ(watch.state(triggered_at(0), triggered_at(2)), State::kWaiting);
  watch.look(store);
  EXPECT_EQ(watch.state(triggered_at(0), triggered_at(7)), State::kTriggered);
  EXPECT_EQ(watch.state(triggered_at(0), triggered_at(8)), State::kHoldingOff);
  EXPECT_EQ(watch.state(triggered_at(0), triggered_at(25)), State::kWaiting);
}

/// A finding fires once for each moment at which it began, however often it is told; one without a moment never does.
TEST(TriggerWatch, AFindingFiresWhereItBegan) {
  const auto store = trigger_store(trigger_samples({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  Trigger trigger;
  trigger.kind = Trigger::Kind::kFinding;
  trigger.code = "slave-fell";
  trigger.hold_off = 0;
  const auto found = [](std::string_view code, int slave, Nanoseconds from) {
    return Finding{code, Severity::kError, slave, from, from};
  };
  std::vector<Finding> findings{found("slave-fell", 1, triggered_at(6)), found("frames-lost", -1, triggered_at(2)),
                                found("slave-fell", 0, 0)};
  TriggerWatch watch(trigger);
  EXPECT_TRUE(watch.look(store));
  watch.hear(findings, store);
  watch.hear(findings, store);
  ASSERT_EQ(watch.episodes().size(), 1U);
  EXPECT_EQ(watch.episodes()[0].cycle, 6U);
  EXPECT_EQ(watch.episodes()[0].slave, 1);
  findings.push_back(found("slave-fell", 0, triggered_at(8)));
  watch.hear(findings, store);
  EXPECT_EQ(watch.episodes().size(), 2U);
  trigger.slave = 0;
  TriggerWatch of_one(trigger, triggered_at(7));
  of_one.hear(findings, store);
  ASSERT_EQ(of_one.episodes().size(), 1U);
  EXPECT_EQ(of_one.episodes()[0].cycle, 8U);
}

}  // namespace
}  // namespace syncline
