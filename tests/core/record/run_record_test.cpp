// SPDX-License-Identifier: Apache-2.0
#include "record/run_record.h"

#include <gtest/gtest.h>

#include <optional>

namespace syncline {
namespace {

NetworkConfig running_machine() {
  NetworkConfig config;
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = 250 * kMicrosecond;
  config.slaves.emplace_back().name = "Coupler";
  config.slaves.emplace_back().name = "Servo";
  config.dc.enabled = true;
  config.dc.sync_window.enabled = true;
  config.dc.sync_window.exponent = 9;
  return config;
}

TEST(RunRecord, LimitsAndNamesAreThoseOfTheConfigurationThatRuns) {
  const RunRecord record(running_machine());
  EXPECT_EQ(record.limits(), (RunLimits{250 * kMicrosecond, 511, 4000}));
  EXPECT_EQ(record.slave_name(1), "Servo");
  EXPECT_EQ(record.slave_name(7), "7");
  auto unmonitored = running_machine();
  unmonitored.dc.sync_window.enabled = false;
  unmonitored.dc.dcm.mode = DcmMode::kOff;
  EXPECT_EQ(limits_of(unmonitored), (RunLimits{250 * kMicrosecond, 0, 0}));
  auto without_clocks = running_machine();
  without_clocks.dc.enabled = false;
  EXPECT_EQ(limits_of(without_clocks), (RunLimits{250 * kMicrosecond, 0, 0}));
}

/// One slave is read in each cycle: of two clocks among a hundred terminals readings reach as far back as the cycles.
TEST(RunRecord, KeepsTheReadingsOfFewClocksAmongManySlavesAsLongAsTheCycles) {
  NetworkConfig config;
  config.slaves.resize(100);
  config.slaves[3].dc.emplace();
  config.slaves[7].dc.emplace();
  config.cyclic.resize(1);
  config.cyclic.front().cycle_time = kMillisecond;
  constexpr std::size_t kLongRun = 40'000;
  for (const std::size_t capacity : {std::size_t{0}, kLongRun}) {  // of a live run, and of a recording
    RunRecord record(config, capacity);
    for (std::size_t i = 0; i < kLongRun; ++i) {
      CycleSample sample;
      sample.cycle = i;
      sample.send_time = kSecond + static_cast<Nanoseconds>(i) * kMillisecond;
      sample.flags = CycleSample::kSlaveFollows;
      sample.slave_position = i % 2 == 0 ? 3 : 7;
      record.add(std::span(&sample, 1));
    }
    for (const std::size_t slave : {3, 7}) {
      const auto& series = record.samples().series(Signal::kSlaveDeviation, slave);
      EXPECT_EQ(series.first_time(), kSecond + (slave == 3 ? 0 : kMillisecond)) << slave << " of " << capacity;
      EXPECT_EQ(series.count(0, INT64_MAX), kLongRun / 2);
    }
  }
}

TEST(RunRecord, KeepsTheLastSnapshotOfTheRunAndTheLatestEvents) {
  RunRecord record(running_machine());
  Snapshot online;
  online.online = true;
  online.cycles = 77;
  record.add(online);
  record.add(Snapshot{});  // offline: says nothing about the run
  EXPECT_EQ(record.snapshot().cycles, 77U);
  constexpr std::size_t kMore = 10;
  for (std::size_t i = 0; i < RunRecord::kMostEvents + kMore; ++i)
    record.add(Event{static_cast<Nanoseconds>(i), -1, events::Online{}});
  EXPECT_EQ(record.events().size(), RunRecord::kMostEvents);
  EXPECT_EQ(record.forgotten_events(), kMore);
  EXPECT_EQ(record.events().front().time, static_cast<Nanoseconds>(kMore));
}

/// The running master takes other parameters: it is held against them, and what was before is no loss.
TEST(RunRecord, TakesTheLimitThatIsInForce) {
  RunRecord record(running_machine());
  CycleSample sample;
  sample.send_time = kSecond;
  sample.master_state = 8;
  sample.slaves_sync = sample.master_sync = SyncState::kInSync;
  record.add(std::span(&sample, 1));
  Snapshot now;
  now.online = true;
  now.time = kSecond;
  now.dcm.in_sync_limit = 4'000;
  record.add(now);
  EXPECT_EQ(record.standing(), (RunStanding{{250 * kMicrosecond, 511, 4'000}, kSecond}));
  now.dcm.in_sync_limit = 900;
  now.dcm.times_configured = 1;
  record.add(now);
  EXPECT_EQ(record.standing(), (RunStanding{{250 * kMicrosecond, 511, 900}, std::nullopt}));
  sample.send_time = 2 * kSecond;
  ++sample.cycle;
  record.add(std::span(&sample, 1));
  EXPECT_EQ(record.standing().armed, 2 * kSecond);
}

TEST(RunRecord, SamplesAndSnapshotsReachTheStore) {
  RunRecord record(running_machine());
  CycleSample sample;
  sample.cycle = 1;
  sample.send_time = kSecond;
  sample.flags = CycleSample::kDcmActive | CycleSample::kReferenceValid;
  sample.dcm_error_ns = 12;
  record.add(std::span(&sample, 1));
  Snapshot online;
  online.online = true;
  online.time = kSecond;
  online.slaves.resize(2);
  online.slaves[1].present = true;
  online.slaves[1].al_status = 8;
  record.add(online);
  EXPECT_EQ(record.samples().value(Signal::kDcmError, kSecond)->value, 12);
  EXPECT_EQ(record.samples().value(Signal::kAlState, 1, kSecond)->value, 8);
  EXPECT_TRUE(record.findings().empty()) << "it was not in OP";
}

/// The master was on its way for two seconds before its first cyclic frame: a finding says the moment that the axis of
/// the plots has, and in a recording that began later the one of that.
TEST(RunRecord, FindingsCountTheirMomentsAsThePlotsDo) {
  RunRecord record(running_machine());
  record.add(Event{kSecond, -1, events::Online{}});
  for (std::uint64_t cycle = 0; cycle < 4000; ++cycle) {
    CycleSample sample;
    sample.cycle = cycle;
    sample.send_time = 3 * kSecond + static_cast<Nanoseconds>(cycle) * kMillisecond;
    sample.master_state = 8;
    record.add(std::span(&sample, 1));
  }
  record.add(Event{5 * kSecond, 1, events::SlaveLost{}});
  Snapshot snapshot;
  snapshot.online = true;
  snapshot.time = 7 * kSecond;
  snapshot.slaves.resize(2);
  snapshot.slaves[0].present = true;
  snapshot.slaves[1].absent_since = 5 * kSecond;
  record.add(snapshot);
  const auto moment = [](const std::vector<Finding>& findings) -> std::optional<std::int64_t> {
    for (const auto& finding : findings) {
      for (const auto& figure : finding.figures) {
        if (figure.unit == Figure::Unit::kMoment) return figure.value;
      }
    }
    return std::nullopt;
  };
  EXPECT_EQ(moment(record.findings()), 2 * kSecond);
  EXPECT_EQ(moment(record.findings(4 * kSecond)), kSecond);
}

}  // namespace
}  // namespace syncline
