// SPDX-License-Identifier: Apache-2.0
#include "trace/watch_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "channels/cycle_sample.h"
#include "config/identity.h"
#include "trace/csv.h"
#include "trace/sample_store.h"
#include "trace/trigger.h"

namespace syncline {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

const WatchedVariable kPosition{"Servo.Position", "DINT", false, 0, 32, 1};
const WatchedVariable kReady{"Servo.Ready", "BOOL", false, 32, 1, 1};
const WatchedVariable kSpeed{"Servo, speed", "LREAL", true, 64, 64, 1};

CycleSample sample_of(std::uint64_t cycle, std::uint32_t list, std::initializer_list<std::uint64_t> values,
                      std::uint16_t known = 0xFFFF) {
  CycleSample sample;
  sample.cycle = cycle;
  sample.send_time = static_cast<Nanoseconds>(cycle) * kMillisecond;
  sample.watch_list = list;
  std::size_t place = 0;
  for (const auto value : values) {
    if ((known >> place & 1) != 0) {
      sample.watched[place] = value;
      sample.watched_known = static_cast<std::uint16_t>(sample.watched_known | 1U << place);
    }
    ++place;
  }
  return sample;
}

TEST(WatchLists, KeepTheNumbersOfVariablesFromListToList) {
  WatchLists lists;
  EXPECT_EQ(lists.command().list, 0U);
  ASSERT_TRUE(lists.add(std::vector{kPosition, kReady}));
  ASSERT_TRUE(lists.add(std::vector{kSpeed, kPosition}));
  EXPECT_EQ(lists.variables(), (std::vector{kPosition, kReady, kSpeed}));
  EXPECT_EQ(lists.latest(), (std::vector{kSpeed, kPosition}));
  const auto command = lists.command();
  EXPECT_EQ(command.list, 2U);
  EXPECT_EQ(command.count, 2);
  EXPECT_EQ(command.places[0], (WatchedPlace{true, 64, 64, 1}));
  EXPECT_EQ(lists.bits(sample_of(1, 1, {7, 1}), 0), 7U);
  EXPECT_EQ(lists.bits(sample_of(1, 2, {9, 7}), 0), 7U);
  EXPECT_FALSE(lists.bits(sample_of(1, 2, {9, 7}), 1)) << "not watched in that list";
  EXPECT_FALSE(lists.bits(sample_of(1, 1, {7, 1}, 0b10), 0)) << "not known in that cycle";
  EXPECT_FALSE(lists.bits(sample_of(1, 3, {7, 1}), 0)) << "a list that nobody has told of";
  EXPECT_FALSE(lists.bits(sample_of(1, 0, {7, 1}), 0));
}

TEST(WatchLists, RefuseWhatIsTooMuch) {
  WatchLists lists;
  std::vector<WatchedVariable> many;
  for (std::uint32_t i = 0; i < kMostWatched; ++i) many.push_back({"v" + std::to_string(i), "UINT", false, i, 16, 0});
  ASSERT_TRUE(lists.add(many));
  auto more = many;
  more.push_back(kPosition);
  EXPECT_FALSE(lists.add(more));
  EXPECT_FALSE(lists.add(std::vector{kPosition, kPosition})) << "one place for each";
  EXPECT_EQ(lists.lists().size(), 1U);
  for (auto& variable : many) variable.bit_offset += 100;
  EXPECT_TRUE(lists.add(many));
  EXPECT_EQ(lists.variables().size(), WatchLists::kMostVariables);
  EXPECT_FALSE(lists.add(std::vector{kPosition})) << "a run holds no more";
  EXPECT_EQ(lists.variables().size(), WatchLists::kMostVariables);
  EXPECT_TRUE(lists.add(std::vector{many[3]})) << "but those that it has";
}

std::vector<float> drawn(const SampleStore& store, std::size_t variable) {
  std::vector<float> values;
  store.series(Signal::kVariable, variable).for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds, float value) {
    values.push_back(value);
  });
  return values;
}

TEST(WatchedSeries, HoldEachCycleOfTheListsThatHaveThem) {
  SampleStore store({.slaves = 2});
  store.append(std::vector{sample_of(1, 0, {}), sample_of(2, 0, {})});
  ASSERT_TRUE(store.watch(std::vector{kPosition, kReady}));
  store.append(std::vector{sample_of(3, 0, {}), sample_of(4, 1, {0xFFFF'FFFE, 1}), sample_of(5, 1, {3, 0}, 0b10)});
  ASSERT_TRUE(store.watch(std::vector{kReady}));
  store.append(std::vector{sample_of(6, 1, {4, 1}), sample_of(7, 2, {1}), sample_of(10, 2, {0})});
  const auto position = drawn(store, 0), ready = drawn(store, 1);
  const std::vector<bool> has{false, false, false, true, false, true, false, false, false};
  ASSERT_EQ(position.size(), has.size()) << "with the gap where cycles are missing";
  for (std::size_t i = 0; i < has.size(); ++i) EXPECT_EQ(!std::isnan(position[i]), has[i]) << i;
  EXPECT_EQ(position[3], -2.0F);
  EXPECT_EQ(position[5], 4.0F);
  EXPECT_EQ(ready[4], 0.0F) << "a zero that is known is a zero";
  EXPECT_TRUE(std::isnan(ready[7]));
  EXPECT_EQ(ready[8], 0.0F);
  EXPECT_FALSE(store.value(Signal::kVariable, 0, 10 * kMillisecond)) << "too old";
  EXPECT_EQ(store.value(Signal::kVariable, 1, 10 * kMillisecond)->value, 0.0F);
  EXPECT_EQ(store.cycle_at(4 * kMillisecond), 4U);
}

/// A ring that has gone round: what comes late has the same times.
TEST(WatchedSeries, ThatComeLateStandBesideTheOthers) {
  SampleStore store({.slaves = 1, .cycle_capacity = 8192});
  std::vector<CycleSample> samples;
  for (std::uint64_t cycle = 0; cycle < 21'000; ++cycle) samples.push_back(sample_of(cycle, 0, {}));
  store.append(samples);
  ASSERT_TRUE(store.watch(std::vector{kPosition}));
  const auto& series = store.series(Signal::kVariable, 0);
  const auto& axis = store.series(Signal::kLateness);
  for (int round = 0; round < 5; ++round) {
    for (auto& sample : samples) sample = sample_of(sample.cycle + samples.size(), 1, {sample.cycle + samples.size()});
    store.append(std::span(samples).first(3'333));
    ASSERT_EQ(series.size(), axis.size());
    ASSERT_EQ(series.first_time(), axis.first_time());
    const auto last = samples[3'332].cycle;
    EXPECT_EQ(series.at(INT64_MAX - 1)->value, static_cast<float>(last));
    const auto extent = series.extent(INT64_MIN, INT64_MAX);
    ASSERT_TRUE(extent);
    EXPECT_EQ(extent->max, static_cast<float>(last));
    std::size_t wrong = 0;
    series.for_each(INT64_MIN, INT64_MAX, [&](Nanoseconds time, float value) {
      if (!std::isnan(value) && static_cast<Nanoseconds>(value) != time / kMillisecond) ++wrong;
    });
    EXPECT_EQ(wrong, 0U);
    samples.resize(3'333);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i].cycle = last - samples.size() + 1 + i;
  }
}

TEST(WatchedSeries, OfNoNumberAreGaps) {
  SampleStore store({.slaves = 2});
  ASSERT_TRUE(store.watch(std::vector{kSpeed}));
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  store.append(std::vector{sample_of(1, 1, {bits(2.5)}), sample_of(2, 1, {bits(std::nan(""))}),
                           sample_of(3, 1, {bits(-std::numeric_limits<double>::infinity())}),
                           sample_of(4, 1, {bits(1e300)})});
  const auto values = drawn(store, 0);
  EXPECT_EQ(values[0], 2.5F);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(std::isnan(values[2]));
  EXPECT_EQ(values[3], std::numeric_limits<float>::max());
}

TEST(WatchedTable, HasAColumnForEachVariableAndExactNumbers) {
  WatchLists lists;
  ASSERT_TRUE(lists.add(std::vector{kPosition, kSpeed}));
  ASSERT_TRUE(lists.add(std::vector{kReady}));
  EXPECT_THAT(sample_csv_header(lists), EndsWith(",Servo.Position,\"Servo, speed\",Servo.Ready\n"));
  EXPECT_THAT(sample_csv_header(), testing::Not(HasSubstr("Servo")));
  std::string text;
  append_sample_csv(text, std::vector{sample_of(1, 1, {0x7FFF'FFFF, std::bit_cast<std::uint64_t>(0.1)})}, lists);
  EXPECT_THAT(text, EndsWith(",2147483647,0.1,\n"));
  text.clear();
  append_sample_csv(text, std::vector{sample_of(1, 1, {5, 0}, 0b10)}, lists);
  EXPECT_THAT(text, EndsWith(",,0,\n")) << "not known is empty, a zero is one";
  text.clear();
  append_sample_csv(text, std::vector{sample_of(1, 2, {1})}, lists);
  EXPECT_THAT(text, EndsWith(",,,1\n"));
}

TEST(WatchedTrigger, FiresOnALevelAndABandOfAVariable) {
  SampleStore store({.slaves = 2});
  ASSERT_TRUE(store.watch(std::vector{kReady, kPosition}));
  std::vector<CycleSample> samples;
  for (std::uint64_t cycle = 1; cycle <= 100; ++cycle)
    samples.push_back(sample_of(cycle, 1, {cycle >= 40 ? 1U : 0U, cycle * 10}, cycle == 70 ? 0b01 : 0b11));
  store.append(samples);
  Trigger trigger;
  trigger.signal = Signal::kVariable;
  trigger.variable = "Servo.Position";
  trigger.level = 500;
  trigger.hold_off = 0;
  TriggerWatch level(trigger);
  EXPECT_TRUE(level.look(store));
  ASSERT_EQ(level.episodes().size(), 1U);
  EXPECT_EQ(level.episodes()[0].cycle, 50U);
  EXPECT_EQ(level.episodes()[0].value, 500);
  EXPECT_EQ(level.episodes()[0].slave, 1) << "whose variable it is";
  trigger.kind = Trigger::Kind::kWindow;
  trigger.low = 300;
  trigger.high = 700;
  TriggerWatch band(trigger);
  (void)band.look(store);
  EXPECT_TRUE(band.episodes().empty()) << "it leaves the band in a gap, and nothing was crossed";
  trigger.high = 800;
  TriggerWatch wider(trigger);
  (void)wider.look(store);
  ASSERT_EQ(wider.episodes().size(), 1U);
  EXPECT_EQ(wider.episodes()[0].cycle, 81U);
  trigger.variable = "Servo.Ready";
  trigger.kind = Trigger::Kind::kLevel;
  trigger.level = 1;
  TriggerWatch ready(trigger);
  (void)ready.look(store);
  ASSERT_EQ(ready.episodes().size(), 1U);
  EXPECT_EQ(ready.episodes()[0].cycle, 40U);
  trigger.variable = "Nobody's";
  TriggerWatch nothing(trigger);
  EXPECT_TRUE(nothing.look(store));
  EXPECT_TRUE(nothing.episodes().empty());
}

}  // namespace
}  // namespace syncline
