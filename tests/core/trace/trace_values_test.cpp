// SPDX-License-Identifier: Apache-2.0
// What other rooms rely on, asked for where it is made.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "trace/dcm_log.h"
#include "trace/lasting_magnitude.h"
#include "trace/run_report.h"
#include "trace/sample_store.h"
#include "trace/slave_figures.h"
#include "trace/spectrum.h"
#include "trace/sync_overview.h"

namespace syncline {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

CycleSample cycle(Nanoseconds time) {
  CycleSample sample;
  sample.send_time = time;
  sample.master_state = static_cast<std::uint8_t>(AlState::kOp);
  return sample;
}

TEST(RunReportValues, WhatSlavesCountStandsInTheReport) {
  NetworkConfig config;
  config.slaves.resize(1);
  Snapshot snapshot;
  snapshot.slaves.resize(1);
  snapshot.slaves[0].evidence.outputs.exceeded.total = 4;
  snapshot.slaves[0].evidence.calc_and_copy_ns = 62'500;
  const auto report = RunRecorder(config).finish(snapshot);
  EXPECT_EQ(report.slaves[0].evidence.outputs.exceeded.total, 4U);
  EXPECT_EQ(report.slaves[0].evidence.calc_and_copy_ns, 62'500);
}

TEST(LastingMagnitude, BegunAnewKnowsNothingOfBefore) {
  LastingMagnitude lasting;
  for (int ms = 0; ms < 1'000; ++ms) lasting.add(ms * kMillisecond, 900);
  ASSERT_TRUE(lasting.largest());
  lasting.clear();
  EXPECT_FALSE(lasting.largest());
  lasting.add(kSecond, 950);
  EXPECT_FALSE(lasting.largest()) << "it has not lasted since";
}

TEST(SyncOverviewValues, TheFirstSlaveInSyncAgainIsNotAllOfThem) {
  OverviewRecorder recorder(3);
  const auto read = [&recorder](int ms, int slave) {
    auto sample = cycle(ms * kMillisecond);
    sample.slaves_sync = sample.master_sync = SyncState::kInSync;
    sample.flags = CycleSample::kFollowersRead | CycleSample::kSlaveFollows;
    sample.slave_position = static_cast<std::int16_t>(slave);
    recorder.add(std::span(&sample, 1));
  };
  for (int ms = 1; ms < 100; ++ms) read(ms, ms % 2);
  const auto before = recorder.overview().slaves.of_all_since();
  for (const int slave : {0, 1}) recorder.add(Event{100 * kMillisecond, slave, events::SlaveLost{}});
  recorder.add(Event{150 * kMillisecond, 0, events::SlavesInSync{}});
  EXPECT_EQ(recorder.overview().slaves.of_all_since(), before) << "the other one is away";
  recorder.add(Event{160 * kMillisecond, 1, events::SlavesInSync{}});
  EXPECT_EQ(recorder.overview().slaves.of_all_since(), 160 * kMillisecond);
}

TEST(SampleStoreValues, WhatIsReadNowAndThenIsOldAfterTenCycles) {
  const SampleStore store({.slaves = 2, .cycle_time = 2 * kMillisecond});
  int readings = 0;
  for (const auto& row : signals()) {
    if (row.form != SignalInfo::Form::kReadings || row.scope == SignalInfo::Scope::kSlave) continue;
    EXPECT_EQ(store.longest_gap(row.id), 20 * kMillisecond);
    ++readings;
  }
  EXPECT_GT(readings, 0);
  EXPECT_GE(store.longest_gap(Signal::kSlaveDeviation), 20 * kMillisecond);
}

TEST(SampleStoreValues, WhatARecordingHoldsOfAStateIsThereChangeByChange) {
  SampleStore store({.slaves = 2});
  std::vector<CycleSample> cycles;
  for (int i = 1; i <= 100; ++i) cycles.push_back(cycle(i * kMillisecond));
  store.append(cycles);
  const std::array times{10 * kMillisecond, 20 * kMillisecond, 30 * kMillisecond, 40 * kMillisecond};
  const std::array values{8.0F, 4.0F, kUnknown, 2.0F};
  store.restore(Signal::kAlState, 1, times, values, 90 * kMillisecond);
  const auto at = [&store](int ms) -> std::optional<float> {
    const auto reading = store.value(Signal::kAlState, 1, ms * kMillisecond);
    return reading ? std::optional(reading->value) : std::nullopt;
  };
  EXPECT_FALSE(at(5));
  EXPECT_EQ(at(15), 8.0);
  EXPECT_EQ(at(25), 4.0);
  EXPECT_FALSE(at(35));
  EXPECT_EQ(at(45), 2.0);
  EXPECT_EQ(at(89), 2.0);
  EXPECT_FALSE(store.value(Signal::kAlState, 0, 45 * kMillisecond)) << "of the other slave nothing";
}

TEST(DcmLogValues, AMarkInFrontOfTheTextIsNoPartOfIt) {
  const auto row = std::string(dcm_log_header()) + "1;2;3;4;5;6;7;8;9;10;11;12;13;14;15;16\n";
  const auto plain = read_dcm_table(row), marked = read_dcm_table("\xEF\xBB\xBF" + row);
  ASSERT_TRUE(plain);
  ASSERT_TRUE(marked);
  EXPECT_EQ(marked->columns, plain->columns);
  EXPECT_EQ(marked->rows.size(), plain->rows.size());
}

TEST(KnownFrequencies, MainsAndTasksHaveTheirThirdHarmonicToo) {
  const std::array periods{0.004};
  const auto known = known_frequencies(0.001, 0, periods);
  using Kind = KnownFrequency::Kind;
  for (const double frequency : {50.0, 100.0, 150.0, 60.0, 120.0, 180.0})
    EXPECT_EQ(std::ranges::count(known, KnownFrequency{Kind::kMains, frequency}), 1) << frequency;
  for (const double frequency : {250.0, 500.0, 750.0})
    EXPECT_EQ(std::ranges::count(known, KnownFrequency{Kind::kTask, frequency}), 1) << frequency;
  EXPECT_EQ(known.size(), 9U);
}

TEST(SlaveFigureValues, ALimitOfOneIsALimitAndTheEndIsNoPartOfTheStretch) {
  SampleStore store({.slaves = 1});
  std::vector<CycleSample> cycles;
  for (int i = 1; i <= 20; ++i) {
    auto sample = cycle(i * kMillisecond);
    sample.cycle = static_cast<std::uint64_t>(i);
    sample.flags = CycleSample::kSlaveFollows;
    sample.slave_position = 0;
    sample.slave_deviation_ns = i;
    cycles.push_back(sample);
  }
  store.append(cycles);
  SlaveFigureRound round;
  round.aim(store, kMillisecond, 10 * kMillisecond, 1);
  ASSERT_TRUE(round.work(1'000));
  const auto& figures = round.figures().front();
  ASSERT_TRUE(figures.newest);
  EXPECT_EQ(figures.newest->value, 9) << "the tenth begins what comes behind";
  EXPECT_EQ(figures.age, kMillisecond - 1);
  EXPECT_EQ(figures.statistics.count(), 9U);
  EXPECT_EQ(figures.over, 8U);
}

}  // namespace
}  // namespace syncline
