// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.h"
#include "tests/scenario/machine_run.h"
#include "trace/csv.h"

/// Whether what is said about synchronisation is so, on machines with something known wrong, or nothing.
namespace syncline {
namespace {

class SyncVerdictOfAMachine : public test::MachineRun, public ::testing::WithParamInterface<std::uint64_t> {
 protected:
  Random random{GetParam()};

  void SetUp() override {
    network.sim.seed = GetParam();
    network.sim.host_jitter = JitterProfile::quiet();
    dc().sync_window.enabled = true;
  }
  DcMasterSettings& dc() { return network.project.master.dc; }
  void add(const DeviceDescription& device, const std::string& behaviour = "generic") {
    network.add(device, behaviour);
    auto& slave = network.sim.slaves.back();
    slave.oscillator.ppm = random.uniform(-45, 45);
    slave.oscillator.start_offset = static_cast<Nanoseconds>(random.uniform(0, 4e9));
    slave.cable_m = random.uniform(0.5, 60);
  }
  void two_axes() {
    add(test::io8());
    add(test::servo(), "servo-y");
    add(test::servo(), "servo-y");
  }
  Nanoseconds step() {
    const auto size = static_cast<Nanoseconds>(random.uniform(20'000, 60'000));
    return random.uniform() < 0.5 ? -size : size;
  }
  /// First event of a kind, told at or after a time of the scenario.
  [[nodiscard]] const Event* first(EventKind kind, Nanoseconds after) const {
    const auto found =
        std::ranges::find_if(events, [&](const Event& e) { return e.kind() == kind && e.time >= start + after; });
    return found == events.end() ? nullptr : &*found;
  }
  [[nodiscard]] const Event* out_of_sync(Nanoseconds after = 0) const {
    return first(kind_of<events::SlavesOutOfSync>, after);
  }
  /// Of the counts in all events of a kind.
  template <class What>
  [[nodiscard]] std::int64_t sum() const {
    std::int64_t total = 0;
    for (const auto& event : events) {
      if (const auto* what = event.as<What>()) total += what->count;
    }
    return total;
  }
  void expect_no_sync_beside_an_error() const {
    for (const auto& sample : samples) {
      if (sample.dcm_error_code == 0) continue;
      ASSERT_NE(sample.master_sync, SyncState::kInSync) << "cycle " << sample.cycle;
    }
  }
};

/// In bus shift the or-ed 0x092C has the reference clock's error against the host in it; on a bad host that is tens of
/// microseconds, while the slaves follow their reference clock by nanoseconds.
TEST_P(SyncVerdictOfAMachine, ABadHostIsNoDeviationOfTheSlaves) {
  network.sim.host_jitter = JitterProfile::bad();
  dc().dcm.set_value = 400 * kMicrosecond;
  two_axes();
  go_online();
  run_until(20 * kSecond);
  EXPECT_GE(snapshot.state, AlState::kPreop) << log();
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync) << log();
  EXPECT_EQ(out_of_sync(), nullptr) << log();
  const auto report = recorder->finish(snapshot);
  EXPECT_FALSE(report.slaves[0].deviation_max_ns);
  ASSERT_TRUE(report.deviation_max_ns);
  EXPECT_LE(*report.deviation_max_ns, 127);
  expect_no_sync_beside_an_error();
}

/// A slave in front of the reference clock gets the master's time and is no follower.
TEST_P(SyncVerdictOfAMachine, ThoseBehindAReferenceClockInTheMiddleFollowIt) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    network.project.slaves.clear();
    network.sim.slaves.clear();
    events.clear();
    for (int i = 0; i < 5; ++i) add(test::io8());
    dc().reference_clock = 1;
    dc().dcm.mode = mode;
    go_online();
    run_until(8 * kSecond);
    EXPECT_EQ(snapshot.state, AlState::kOp) << log();
    EXPECT_EQ(snapshot.dc.state, SyncState::kInSync) << log();
    EXPECT_EQ(snapshot.dc.followers, 3);
    EXPECT_EQ(out_of_sync(), nullptr) << log();
    const auto report = recorder->finish(snapshot);
    EXPECT_FALSE(report.slaves[0].deviation_ns);
    EXPECT_FALSE(report.slaves[1].deviation_ns);
    EXPECT_LE(report.deviation_max_ns.value_or(INT32_MAX), 127);
  }
}

TEST_P(SyncVerdictOfAMachine, WhoIsNotMonitoredIsNotInSync) {
  dc().sync_window.enabled = false;
  dc().dcm.mode = DcmMode::kMasterShift;
  two_axes();
  fault(FaultKind::kClockStep, 2, 7 * kSecond).value_ns = 900'000;
  go_online();
  run_until(8 * kSecond);
  // Where the step falls in the cycle decides whether the drive misses so much that it gives up.
  EXPECT_GE(snapshot.state, AlState::kSafeop) << log();
  EXPECT_EQ(snapshot.dc.state, SyncState::kNotMonitored);
  EXPECT_TRUE(std::ranges::none_of(samples, [](const auto& s) { return s.slaves_sync == SyncState::kInSync; }));
  std::string table;
  append_sample_csv(table, std::span(samples).last(1));
  EXPECT_NE(table.find(",0,,1,"), std::string::npos) << table;  // frame_lost, dc_in_sync, dcm_in_sync
  // But what was read is told.
  const auto report = recorder->finish(snapshot);
  EXPECT_GT(report.slaves[2].deviation_max_ns.value_or(0), 10'000);
  EXPECT_LE(report.slaves[1].deviation_max_ns.value_or(INT32_MAX), 127);
}

TEST_P(SyncVerdictOfAMachine, LostFramesAreToldOnce) {
  two_axes();
  int lost = 0;
  const auto first_at = static_cast<Nanoseconds>(random.uniform(5e9, 6e9));
  for (int i = 0; i < 7; ++i) {
    const auto count = random.uniform() < 0.5 ? 1U : 2U;
    fault(FaultKind::kLoseFrames, -1, first_at + i * 300 * kMillisecond).count = count;
    lost += static_cast<int>(count);
  }
  go_online();
  run_until(9 * kSecond);
  EXPECT_EQ(snapshot.lost_frames, static_cast<std::uint64_t>(lost)) << log();
  EXPECT_EQ(sum<events::FramesLost>(), lost) << log();
  EXPECT_EQ(snapshot.late_frames, 0U);
}

TEST_P(SyncVerdictOfAMachine, AStepOfTheReferenceClockIsOutOfSyncAtOnce) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    network.project.slaves.clear();
    network.sim.slaves.clear();
    network.sim.faults.clear();
    events.clear();
    dc().dcm.mode = mode;
    two_axes();
    const auto at = static_cast<Nanoseconds>(random.uniform(6e9, 7e9));
    fault(FaultKind::kClockStep, 0, at).value_ns = step();
    go_online();
    run_until(at - 50 * kMillisecond);
    ASSERT_EQ(snapshot.dc.state, SyncState::kInSync) << log();
    run_until(at + 200 * kMillisecond);
    const auto* out = out_of_sync(at - kMillisecond);
    ASSERT_NE(out, nullptr) << log();
    EXPECT_LE(out->time, start + at + 10 * kMillisecond) << log();
    EXPECT_EQ(out->as<events::SlavesOutOfSync>()->over_limit, 2U) << "both followers at once";
    EXPECT_EQ(out->slave, -1) << "it is none of theirs";
    EXPECT_GT(out->as<events::SlavesOutOfSync>()->deviation_ns, 10'000);
  }
}

TEST_P(SyncVerdictOfAMachine, AStepOfASlaveIsOutOfSyncAtOnceAndItsOwn) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    network.project.slaves.clear();
    network.sim.slaves.clear();
    network.sim.faults.clear();
    events.clear();
    dc().dcm.mode = mode;
    two_axes();
    for (int i = 0; i < 20; ++i) add(test::io8());
    const auto at = static_cast<Nanoseconds>(random.uniform(6e9, 7e9));
    const int who = 1 + static_cast<int>(random.uniform(0, 21.99));
    fault(FaultKind::kClockStep, who, at).value_ns = step();
    go_online();
    run_until(at + 200 * kMillisecond);
    const auto* out = out_of_sync();
    ASSERT_NE(out, nullptr) << log();
    EXPECT_EQ(out->slave, who) << log();
    EXPECT_GE(out->time, start + at - kMillisecond) << log();
    EXPECT_LE(out->time, start + at + 40 * kMillisecond) << log();
    run_until(at + 6 * kSecond);
    EXPECT_EQ(snapshot.dc.state, SyncState::kInSync) << log();
    // What it did while it was out of sync is shown.
    EXPECT_GT(recorder->finish(snapshot).slaves[static_cast<std::size_t>(who)].deviation_max_ns.value_or(0), 10'000);
  }
}

TEST_P(SyncVerdictOfAMachine, TheMasterIsNotInSyncBesideAnError) {
  two_axes();
  const double host = random.uniform(680, 800) * (random.uniform() < 0.5 ? -1 : 1);
  for (auto& slave : network.sim.slaves) slave.oscillator.ppm -= host;
  dc().dcm.mode = DcmMode::kMasterShift;
  go_online();
  run_until(12 * kSecond);
  EXPECT_NE(snapshot.dcm.error_code, 0U);
  EXPECT_NE(snapshot.dcm.state, SyncState::kInSync);
  expect_no_sync_beside_an_error();
}

TEST_P(SyncVerdictOfAMachine, AStallOfTheHostIsCyclesLeftOutAndNoSync) {
  two_axes();
  dc().dcm.mode = DcmMode::kMasterShift;
  const auto at = static_cast<Nanoseconds>(random.uniform(6e9, 7e9));
  const auto length = static_cast<Nanoseconds>(random.uniform(20e6, 60e6));
  fault(FaultKind::kHostStall, -1, at).value_ns = length;
  go_online();
  run_until(at - 10 * kMillisecond);
  ASSERT_EQ(snapshot.dcm.state, SyncState::kInSync) << log();
  run_until(at + length + kSecond);
  EXPECT_NEAR(static_cast<double>(snapshot.skipped_cycles), static_cast<double>(length) / 1e6, 1.5);
  EXPECT_EQ(sum<events::CyclesLeftOut>(), static_cast<std::int64_t>(snapshot.skipped_cycles)) << log();
  const auto* out = first(kind_of<events::MasterOutOfSync>, at);
  ASSERT_NE(out, nullptr) << log();
  EXPECT_EQ(out->as<events::MasterOutOfSync>()->obstacle, dc::SyncObstacle::kCyclesLeftOut);
  for (const auto& sample : samples) {
    const bool within = sample.send_time >= start + at + length && sample.send_time < start + at + length + kSecond;
    if (within) {
      ASSERT_NE(sample.master_sync, SyncState::kInSync) << log();
    }
  }
  EXPECT_EQ(snapshot.lost_frames, 0U);
}

TEST_P(SyncVerdictOfAMachine, OnADesktopBothAreInSync) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    network.project.slaves.clear();
    network.sim.slaves.clear();
    events.clear();
    network.sim.host_jitter = JitterProfile::desktop();
    dc().dcm.mode = mode;
    two_axes();
    go_online();
    run_until(12 * kSecond);
    EXPECT_EQ(snapshot.state, AlState::kOp) << log();
    EXPECT_EQ(snapshot.dc.state, SyncState::kInSync) << log();
    EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync) << log();
    EXPECT_EQ(out_of_sync(), nullptr) << log();
  }
}

/// One frame in twenty leaves 9 us behind its stamp, so that three of them in a row come now and then.
TEST_P(SyncVerdictOfAMachine, StampsThatAreWrongAlikeAreNoStepOfAClock) {
  for (const auto mode : {DcmMode::kBusShift, DcmMode::kMasterShift}) {
    network.project.slaves.clear();
    network.sim.slaves.clear();
    events.clear();
    network.sim.host_jitter.stamp_error = {{{0, 0}, {0.5, 300}, {0.949, 800}, {0.95, 9'000}, {1, 9'800}}};
    dc().dcm.mode = mode;
    two_axes();
    go_online();
    run_until(20 * kSecond);
    EXPECT_EQ(snapshot.dcm.state, SyncState::kInSync) << log();
    EXPECT_EQ(out_of_sync(), nullptr) << log();
  }
}

/// Nobody moves the timer, and frames slide through SYNC0: not the little that some are held up makes them late there.
TEST_P(SyncVerdictOfAMachine, OutputsThatSlideThroughSync0AreNotHeldUp) {
  network.sim.host_jitter = JitterProfile::desktop();
  dc().dcm.mode = DcmMode::kMasterShiftByApp;
  two_axes();
  for (auto& slave : network.sim.slaves) slave.oscillator.ppm = 16;
  go_online();
  run_until(50 * kSecond);
  for (const std::size_t axis : {1U, 2U}) {
    const auto& missed = snapshot.slaves.at(axis).sm2_missed;
    ASSERT_GT(missed.missed, 20U) << log();
    EXPECT_EQ(missed.by_cause[static_cast<std::size_t>(dc::MissCause::kFrameHeldUp)], 0U) << "of " << missed.missed;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, SyncVerdictOfAMachine, ::testing::Values(1, 2));

}  // namespace
}  // namespace syncline
