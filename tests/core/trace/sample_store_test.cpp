// SPDX-License-Identifier: Apache-2.0
#include "trace/sample_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "channels/event.h"
#include "channels/snapshot.h"
#include "support/random.h"
#include "trace/bus_signals.h"

namespace syncline {
namespace {

CycleSample stored(std::uint64_t cycle) {
  CycleSample s;
  s.cycle = cycle;
  s.send_time = static_cast<Nanoseconds>(cycle) * kMillisecond;
  s.flags = CycleSample::kFollowersRead | CycleSample::kDcmActive | CycleSample::kReferenceValid;
  s.deviation_ns = 12;
  s.dcm_error_ns = -34;
  s.dcm_error_filtered_ns = -30;
  return s;
}

CycleSample stored_lost(std::uint64_t cycle) {
  auto s = stored(cycle);
  s.flags = CycleSample::kFrameLost | CycleSample::kDcmActive;
  return s;
}

Snapshot stored_snapshot(Nanoseconds time, std::uint32_t missed) {
  Snapshot s;
  s.time = time;
  s.online = true;
  s.slaves.resize(2);
  for (auto& slave : s.slaves) slave.present = true;
  s.slaves[1].sm2_missed.known = true;
  s.slaves[1].sm2_missed.missed = missed;
  s.slaves[1].evidence.ports[2].lost_links = 3;
  s.slaves[1].evidence.ports_time = kMillisecond;
  return s;
}

std::vector<float> values(const MinMaxSeries& series) {
  std::vector<float> all;
  series.for_each(INT64_MIN, INT64_MAX, [&all](Nanoseconds, float value) { all.push_back(value); });
  return all;
}

TEST(SampleStore, LostFramesAndInvalidValuesAreGaps) {
  SampleStore store({.slaves = 2});
  auto unmonitored = stored(3);
  unmonitored.flags = 0;
  store.append(std::vector<CycleSample>{stored(1), stored_lost(2), unmonitored});
  const auto largest = values(store.series(Signal::kDeviation));
  ASSERT_EQ(largest.size(), 3U);
  EXPECT_EQ(largest[0], 12);
  EXPECT_TRUE(std::isnan(largest[1]));
  EXPECT_TRUE(std::isnan(largest[2]));
  EXPECT_TRUE(std::isnan(values(store.series(Signal::kDcmError))[2]));
}

/// The controller goes on through an outage with what it learned; that is no reading.
TEST(SampleStore, NothingOfTheControllerIsDrawnThroughAnOutage) {
  SampleStore store({.slaves = 2});
  store.append(std::vector<CycleSample>{stored(1), stored_lost(2), stored_lost(3), stored(4)});
  for (const auto signal : {Signal::kDcmError, Signal::kDcmErrorFiltered, Signal::kFrameError, Signal::kDrift}) {
    const auto drawn = values(store.series(signal));
    ASSERT_EQ(drawn.size(), 4U);
    EXPECT_FALSE(std::isnan(drawn[0])) << info(signal).key;
    EXPECT_TRUE(std::isnan(drawn[1])) << info(signal).key;
    EXPECT_TRUE(std::isnan(drawn[2])) << info(signal).key;
    EXPECT_FALSE(std::isnan(drawn[3])) << info(signal).key;
  }
}

TEST(SampleStore, APresentValueIsNoOlderThanItsGap) {
  SampleStore store({.slaves = 2});
  std::vector<CycleSample> samples{stored(1)};
  for (std::uint64_t cycle = 2; cycle < 20; ++cycle) samples.push_back(stored_lost(cycle));
  store.append(samples);
  EXPECT_TRUE(store.value(Signal::kDcmError, 2 * kMillisecond));
  EXPECT_FALSE(store.value(Signal::kDcmError, 19 * kMillisecond)) << "read 18 ms before";
}

TEST(SampleStore, MissingCyclesLeaveAGap) {
  SampleStore store({});
  store.append(std::vector<CycleSample>{stored(1), stored(5)});
  EXPECT_EQ(store.missing_cycles(), 3U);
  const auto largest = values(store.series(Signal::kDeviation));
  ASSERT_EQ(largest.size(), 3U);
  EXPECT_TRUE(std::isnan(largest[1]));
}

TEST(SampleStore, SlaveReadingsGoToTheirSlave) {
  SampleStore store({.slaves = 3});
  auto s = stored(1);
  s.flags |= CycleSample::kSlaveFollows;
  s.slave_position = 2;
  s.slave_deviation_ns = -7;
  s.sm2_position = 1;
  s.slave_sm2_missed = 4;
  auto foreign = stored(2);
  foreign.flags |= CycleSample::kSlaveFollows;
  foreign.slave_position = 9;  // of another configuration: ignored
  auto leader = stored(3);
  leader.slave_position = 0;  // follows nobody: what it shows is no deviation
  leader.slave_deviation_ns = 30'000;
  store.append(std::vector<CycleSample>{s, foreign, leader});
  EXPECT_EQ(store.value(Signal::kSlaveDeviation, 2, 3 * kMillisecond)->value, -7);
  EXPECT_TRUE(store.series(Signal::kSlaveDeviation, 0).empty());
  EXPECT_EQ(store.value(Signal::kSm2Missed, 1, 3 * kMillisecond)->value, 4);
}

TEST(SampleStore, CountsHoldFromReadingToReadingAndNotThroughAnOutage) {
  SampleStore store({.slaves = 2});
  store.append(std::vector<CycleSample>{stored(1)});
  store.append(stored_snapshot(1 * kMillisecond, 7));
  EXPECT_EQ(store.value(Signal::kSm2Missed, 1, kMillisecond)->value, 7);
  EXPECT_EQ(store.value(port_signal(2, PortSignal::kLostLinks), 1, kMillisecond)->value, 3);
  std::vector<CycleSample> outage;
  for (std::uint64_t cycle = 2; cycle < 40; ++cycle) outage.push_back(stored_lost(cycle));
  store.append(outage);
  EXPECT_EQ(store.heard(Signal::kSm2Missed, 1), 2 * kMillisecond) << "the gap begins with the first lost frame";
  EXPECT_FALSE(store.value(Signal::kSm2Missed, 1, 39 * kMillisecond));
  store.append(stored_snapshot(39 * kMillisecond, 8));
  EXPECT_FALSE(store.value(Signal::kSm2Missed, 1, 39 * kMillisecond)) << "nobody answers";
  store.append(std::vector<CycleSample>{stored(40)});
  store.append(stored_snapshot(40 * kMillisecond, 9));
  EXPECT_EQ(store.value(Signal::kSm2Missed, 1, 40 * kMillisecond)->value, 9);
}

TEST(SampleStore, AnAbsentSlaveHasNoValues) {
  SampleStore store({.slaves = 2});
  store.append(std::vector<CycleSample>{stored(1)});
  store.append(stored_snapshot(kMillisecond, 7));
  auto gone = stored_snapshot(500 * kMillisecond, 7);
  gone.slaves[1].present = false;
  gone.slaves[1].absent_since = 400 * kMillisecond;
  store.append(gone);
  EXPECT_FALSE(store.value(Signal::kSm2Missed, 1, 500 * kMillisecond));
  EXPECT_EQ(store.value(Signal::kSm2Missed, 1, 300 * kMillisecond)->value, 7);
}

TEST(SampleStore, AValueThatIsNoLongerReadEnds) {
  SampleStore store({.slaves = 2});
  auto s = stored(1);
  s.sm2_position = 1;
  s.slave_sm2_missed = 4;
  store.append(std::vector<CycleSample>{s});
  for (std::uint64_t cycle = 2; cycle < 7'000; ++cycle) store.append(std::vector<CycleSample>{stored(cycle)});
  EXPECT_FALSE(store.value(Signal::kSm2Missed, 1, 6'999 * kMillisecond));
  EXPECT_EQ(store.value(Signal::kSm2Missed, 1, kMillisecond)->value, 4);
}

/// However seldom it was read while it answered.
TEST(SampleStore, WhatASilentMailboxSaidLastDoesNotHoldOn) {
  SampleStore store({.slaves = 2});
  auto now = stored_snapshot(kMillisecond, 7);
  auto& counts = now.slaves[1].evidence.outputs.exceeded;
  for (const int at : {1, 9, 17}) {
    now.time = at * kSecond;
    counts = {3, false, now.time};
    store.append(now);
  }
  now.slaves[1].evidence.mailbox_silences = 4;
  now.time = 19 * kSecond;
  store.append(now);
  EXPECT_TRUE(store.value(Signal::kOutputsExceeded, 1, 19 * kSecond));
  now.slaves[1].evidence.mailbox_silences = 5;
  now.time = 20 * kSecond;
  store.append(now);
  EXPECT_FALSE(store.value(Signal::kOutputsExceeded, 1, 20 * kSecond));
  EXPECT_EQ(store.value(Signal::kOutputsExceeded, 1, 16 * kSecond)->value, 3);
  now.slaves[1].evidence.mailbox_silences = 0;
  now.time = counts.time = 21 * kSecond;
  store.append(now);
  EXPECT_EQ(store.value(Signal::kOutputsExceeded, 1, 21 * kSecond)->value, 3);
}

/// One clock is read a cycle, in turn: 300 of them within 300 cycles, three within three.
TEST(SampleStore, AReadingInTurnIsOldAfterTenCyclesOrWhenItsTurnWasMissed) {
  const auto read_in_turn = [](SampleStore& store, std::uint64_t clocks) {
    std::vector<CycleSample> samples;
    for (std::uint64_t cycle = 1; cycle < 4 * clocks + 20; ++cycle) {
      auto s = stored(cycle);
      s.flags |= CycleSample::kSlaveFollows;
      s.slave_position = static_cast<std::int16_t>(cycle % clocks);
      samples.push_back(s);
    }
    store.append(samples);
  };
  SampleStore few({.slaves = 9}), many({.slaves = 300});
  read_in_turn(few, 3);
  read_in_turn(many, 300);
  EXPECT_EQ(few.longest_gap(Signal::kSlaveDeviation), 10 * kMillisecond);
  EXPECT_EQ(many.longest_gap(Signal::kSlaveDeviation), 602 * kMillisecond + kMillisecond / 2);
  const auto last = few.series(Signal::kSlaveDeviation, 2).last_time();
  EXPECT_TRUE(few.value(Signal::kSlaveDeviation, 2, last + 10 * kMillisecond));
  EXPECT_FALSE(few.value(Signal::kSlaveDeviation, 2, last + 10 * kMillisecond + 1));
}

Snapshot in_state(Nanoseconds time, std::uint16_t al_status) {
  auto snapshot = stored_snapshot(time, 0);
  snapshot.slaves[1].al_status = al_status;
  return snapshot;
}
Event state_changed(Nanoseconds time, AlState from, AlState to) { return {time, 1, events::StateChanged{from, to}}; }
std::vector<std::pair<Nanoseconds, float>> al_states(const SampleStore& store) {
  std::vector<std::pair<Nanoseconds, float>> all;
  store.series(Signal::kAlState, 1).for_each(INT64_MIN, INT64_MAX, [&all](Nanoseconds time, float value) {
    all.emplace_back(time, value);
  });
  return all;
}

/// Between two snapshots a slave may fall and come back.
TEST(SampleStore, AFallThatNoSnapshotHasMetIsAmongTheStates) {
  SampleStore store({.slaves = 2});
  store.append(std::vector<CycleSample>{stored(1)});
  store.append(in_state(10 * kMillisecond, 8));
  store.append(in_state(43 * kMillisecond, 8));
  // Also behind a snapshot that shows the same as before.
  store.append(state_changed(20 * kMillisecond, AlState::kOp, AlState::kSafeop));
  store.append(Event{20 * kMillisecond, 1, events::AlStatusError{0x14, 0x1B}});
  store.append(state_changed(22 * kMillisecond, AlState::kSafeop, AlState::kOp));
  store.append(in_state(76 * kMillisecond, 8));
  // Nothing of the run is behind it: the bus is taken down.
  store.append(state_changed(90 * kMillisecond, AlState::kOp, AlState::kInit));
  using Changes = std::vector<std::pair<Nanoseconds, float>>;
  EXPECT_EQ(
      al_states(store),
      (Changes{
          {10 * kMillisecond, 8.F}, {20 * kMillisecond, 4.F}, {20 * kMillisecond, 20.F}, {22 * kMillisecond, 8.F}}));
  EXPECT_EQ(store.value(Signal::kAlState, 1, 21 * kMillisecond)->value, 20);
  EXPECT_EQ(store.heard(Signal::kAlState, 1), 76 * kMillisecond);
}

TEST(SampleStore, AStateHasTheMomentOfItsEventAndNotThatOfTheSnapshot) {
  SampleStore store({.slaves = 2});
  store.append(std::vector<CycleSample>{stored(1)});
  store.append(in_state(10 * kMillisecond, 8));
  store.append(state_changed(21 * kMillisecond, AlState::kOp, AlState::kSafeop));
  store.append(in_state(43 * kMillisecond, 4));
  EXPECT_EQ(al_states(store).back(), std::pair(21 * kMillisecond, 4.F));
  EXPECT_EQ(store.heard(Signal::kAlState, 1), 43 * kMillisecond);
  // Without an event, as of an error that was acknowledged, the snapshot is what there is.
  store.append(in_state(76 * kMillisecond, 8));
  EXPECT_EQ(store.value(Signal::kAlState, 1, 76 * kMillisecond)->value, 8);
  store.append(in_state(109 * kMillisecond, 8));
  EXPECT_EQ(al_states(store).back(), std::pair(76 * kMillisecond, 8.F));
  EXPECT_EQ(store.heard(Signal::kAlState, 1), 109 * kMillisecond);
}

/// It begins at 0 when the slave is in OP again, and until that is counted nobody knows it.
TEST(SampleStore, TheFuseDoesNotShowItsLimitAfterARecovery) {
  SampleStore store({.slaves = 2});
  store.append(std::vector<CycleSample>{stored(1)});
  auto snapshot = stored_snapshot(kMillisecond, 3);
  auto& misses = snapshot.slaves[1].sm2_missed;
  misses.integrator = misses.limit = 9;
  store.append(snapshot);
  EXPECT_EQ(store.value(Signal::kSm2Integrator, 1, kMillisecond)->value, 9);
  misses.settling = true;
  snapshot.time = 20 * kMillisecond;
  store.append(snapshot);
  EXPECT_FALSE(store.value(Signal::kSm2Integrator, 1, 20 * kMillisecond));
  EXPECT_FALSE(store.value(Signal::kSm2CyclesToTrip, 1, 20 * kMillisecond));
  EXPECT_TRUE(store.value(Signal::kSm2Missed, 1, 20 * kMillisecond)) << "its sum stays";
  misses.settling = false;
  misses.integrator = 0;
  snapshot.time = 40 * kMillisecond;
  store.append(snapshot);
  EXPECT_EQ(store.value(Signal::kSm2Integrator, 1, 40 * kMillisecond)->value, 0);
}

TEST(Signals, EachHasItsPlaceItsKeyAndOneSource) {
  std::set<std::pair<std::string_view, bool>> keys;
  for (std::size_t i = 0; i < kSignalCount; ++i) {
    const auto& signal = signals()[i];
    EXPECT_EQ(static_cast<std::size_t>(signal.id), i) << signal.key;
    EXPECT_FALSE(signal.name.empty()) << i;
    EXPECT_FALSE(signal.source.empty()) << signal.key;
    EXPECT_TRUE(keys.insert({signal.key, signal.scope == SignalInfo::Scope::kSlave}).second) << signal.key;
    const int sources = (signal.of_cycle != nullptr) + (signal.of_bus != nullptr) + (signal.of_slave != nullptr);
    const bool by_the_store = signal.id == Signal::kSlaveDeviation || signal.id == Signal::kArrivalPhase ||
                              signal.id == Signal::kSetpointSlips || signal.id == Signal::kVariable;
    EXPECT_EQ(sources, by_the_store ? 0 : 1) << signal.key;
    EXPECT_EQ(find_signal(signal.key, signal.scope), &signal);
  }
}

/// However the stream is cut: gaps in it, lost frames and times that go back included.
TEST(SampleStore, StretchesAreStoredAsSingleCycles) {
  Random random(7);
  std::vector<CycleSample> samples;
  std::uint64_t cycle = 1;
  for (int i = 0; i < 30'000; ++i) {
    cycle += random.next() % 200 == 0 ? 5 : 1;
    auto s = random.next() % 50 == 0 ? stored_lost(cycle) : stored(cycle);
    if (random.next() % 100 == 0) s.flags |= CycleSample::kFrameLate;
    s.late_by_ns = static_cast<std::int32_t>(random.next() % 1000);
    s.wake_lateness_ns = static_cast<std::int32_t>(random.next() % 1000);
    s.send_time += s.wake_lateness_ns;
    if (random.next() % 300 == 0) s.send_time -= 7 * kMillisecond;
    s.wkc_received = static_cast<std::uint16_t>(random.next() % 2);
    s.slave_position = static_cast<std::int16_t>(random.next() % 2);
    s.flags |= CycleSample::kSlaveFollows;
    s.sm2_position = static_cast<std::int16_t>(static_cast<int>(random.next() % 3) - 1);
    s.slave_sm2_missed = static_cast<std::uint32_t>(random.next() % 3);
    samples.push_back(s);
  }
  SampleStore single({.slaves = 2, .cycle_capacity = 8'192}), stretches({.slaves = 2, .cycle_capacity = 8'192});
  for (const auto& sample : samples) single.append(std::span(&sample, 1));
  for (auto rest = std::span<const CycleSample>(samples); !rest.empty();) {
    const auto count = std::min<std::size_t>(random.next() % 5'000, rest.size());
    stretches.append(rest.first(count));
    rest = rest.subspan(count);
  }
  EXPECT_EQ(stretches.missing_cycles(), single.missing_cycles());
  const auto points = [](const MinMaxSeries& series) {
    std::vector<std::pair<Nanoseconds, std::uint32_t>> all;
    series.for_each(INT64_MIN, INT64_MAX, [&all](Nanoseconds time, float value) {
      all.emplace_back(time, std::bit_cast<std::uint32_t>(value));
    });
    return all;
  };
  for (const auto& signal : signals()) {
    if (signal.form == SignalInfo::Form::kCell || signal.form == SignalInfo::Form::kWatched) continue;
    for (std::size_t slave = 0; slave < (signal.scope == SignalInfo::Scope::kSlave ? 2U : 1U); ++slave) {
      EXPECT_TRUE(points(stretches.series(signal.id, slave)) == points(single.series(signal.id, slave))) << signal.key;
      EXPECT_EQ(stretches.heard(signal.id, slave), single.heard(signal.id, slave)) << signal.key;
    }
  }
}

/// The loops over stretches give what the table gives for a cycle.
TEST(SampleStore, ValuesOfStretchesAreThoseOfTheTable) {
  std::vector<CycleSample> samples = {stored(1), stored_lost(2), stored(3)};
  samples[2].dcm_error_ns = std::numeric_limits<std::int32_t>::min();
  for (const auto& signal : signals()) {
    const auto values_of = cycle_values(signal.id);
    ASSERT_EQ(values_of != nullptr, signal.of_cycle != nullptr) << signal.key;
    if (values_of == nullptr) continue;
    std::vector<float> drawn(samples.size());
    values_of(samples, drawn.data());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto number = signal.of_cycle(samples[i]);
      ASSERT_EQ(std::isnan(drawn[i]), !number) << signal.key;
      if (!number) continue;
      EXPECT_EQ(drawn[i], static_cast<float>(as_double(*number))) << signal.key;
    }
  }
}

}  // namespace
}  // namespace syncline
