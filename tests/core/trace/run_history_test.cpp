// SPDX-License-Identifier: Apache-2.0
#include "trace/run_history.h"

#include <gtest/gtest.h>

#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/events/slave_events.h"
#include "channels/snapshot.h"
#include "config/network_config.h"

namespace syncline {
namespace {

CycleSample sample(Nanoseconds time, AlState state = AlState::kOp) {
  CycleSample sample;
  sample.send_time = time;
  sample.master_state = static_cast<std::uint8_t>(state);
  return sample;
}

class RunHistoryTest : public ::testing::Test {
 protected:
  static NetworkConfig three_slaves() {
    NetworkConfig config;
    config.slaves.resize(3);
    return config;
  }
  NetworkConfig config = three_slaves();
  HistoryRecorder recorder{config};
  void add(const CycleSample& sample) { recorder.add(std::span(&sample, 1)); }
  /// SYNC0 every full cycle of the reference clock's time.
  void know_grid() {
    Snapshot snapshot;
    snapshot.dc.sync_base = 10 * kSecond;
    snapshot.dc.enabled = true;
    recorder.add(snapshot);
  }
};

TEST(Spells, JoinWhatLiesTogether) {
  Spells spells;
  spells.note(kSecond, 2, 5);
  spells.note(kSecond + 100 * kMillisecond, 1, 3);
  spells.note(3 * kSecond, 4);
  ASSERT_EQ(spells.list().size(), 2U);
  EXPECT_EQ(spells.list()[0].count, 3U);
  EXPECT_EQ(spells.count(), 7U);
  EXPECT_EQ(spells.largest(), 5);
  EXPECT_TRUE(spells.near({kSecond + 105 * kMillisecond, 2 * kSecond, 0, 0}, 10 * kMillisecond));
  EXPECT_FALSE(spells.near({2 * kSecond, 2 * kSecond, 0, 0}, 10 * kMillisecond));
}

TEST(Spells, StayBoundedOverDaysOfTrouble) {
  Spells spells;
  for (int i = 1; i <= 10000; ++i) spells.note(i * kSecond, 1);
  EXPECT_EQ(spells.list().size(), Spells::kMost);
  EXPECT_EQ(spells.count(), 10000U);
  EXPECT_EQ(spells.last(), 10000 * kSecond);
}

TEST_F(RunHistoryTest, KnowsHowLongTheHostStoodStill) {
  add(sample(kSecond));
  auto late = sample(kSecond + 40 * kMillisecond);
  late.skipped_cycles = 39;
  add(late);
  ASSERT_EQ(recorder.history().stalls.count(), 39U);
  EXPECT_EQ(recorder.history().stalls.largest(), 40 * kMillisecond);
  EXPECT_EQ(recorder.history().stalls.first(), kSecond);
}

/// Of a slave's count only what is new: it stands still, or begins again.
TEST_F(RunHistoryTest, CountsWhatASlaveHasMissedSinceItsLastReading) {
  const auto read = [&](Nanoseconds time, int slave, std::uint32_t count) {
    auto reading = sample(time);
    reading.sm2_position = static_cast<decltype(reading.sm2_position)>(slave);
    reading.slave_sm2_missed = count;
    add(reading);
  };
  read(1 * kSecond, 0, 2);
  read(2 * kSecond, 2, 5);
  read(3 * kSecond, 0, 2);
  read(4 * kSecond, -1, 90);
  read(5 * kSecond, 3, 90);
  read(6 * kSecond, 0, 3);
  read(7 * kSecond, 0, 1);
  read(8 * kSecond, 0, 4);
  const auto& slaves = recorder.history().slaves;
  EXPECT_EQ(slaves[0].missed.count(), 2U + 1U + 3U);
  ASSERT_EQ(slaves[0].missed.list().size(), 3U);
  EXPECT_EQ(slaves[0].missed.first(), kSecond);
  EXPECT_EQ(slaves[0].missed.last(), 8 * kSecond);
  EXPECT_EQ(slaves[1].missed.count(), 0U);
  EXPECT_TRUE(slaves[1].missed.empty());
  EXPECT_EQ(slaves[2].missed.count(), 5U);
}

TEST_F(RunHistoryTest, KnowsFromWhenToWhenAMailboxWasSilent) {
  const auto look = [&](Nanoseconds time, std::uint64_t silences) {
    Snapshot snapshot;
    snapshot.time = time;
    snapshot.slaves.resize(3);
    snapshot.slaves[1].evidence.mailbox_silences = static_cast<decltype(SlaveEvidence::mailbox_silences)>(silences);
    recorder.add(snapshot);
  };
  look(1 * kSecond, 0);
  look(2 * kSecond, 1);
  look(3 * kSecond, 1);
  look(4 * kSecond, 3);
  look(5 * kSecond, 3);
  const auto& slave = recorder.history().slaves[1];
  EXPECT_EQ(slave.mailbox_silences, 3U);
  EXPECT_EQ(slave.silent_from, 2 * kSecond);
  EXPECT_EQ(slave.silent_to, 4 * kSecond);
  EXPECT_EQ(recorder.history().slaves[0].mailbox_silences, 0U);
}

/// Who goes changes the way of those behind it at once; the sweep that misses it comes a little later.
TEST_F(RunHistoryTest, ALossBehindWhoGoesJustThenIsAChangedWay) {
  recorder.add(Event{kSecond, -1, events::Online{}});
  recorder.add(Event{8 * kSecond, 2, events::SlavesOutOfSync{1078, 1}});
  ASSERT_EQ(recorder.history().slave_losses.size(), 1U);
  recorder.add(Event{8 * kSecond + 2 * kMillisecond, 1, events::SlaveLost{}});
  EXPECT_TRUE(recorder.history().slave_losses.empty());
  ASSERT_EQ(recorder.history().way_changes.size(), 1U);
  EXPECT_EQ(recorder.history().way_changes[0].slave, 1);
  EXPECT_EQ(recorder.history().way_changes[0].deviation, 1078);
  // In front of who goes, or long before, it is another matter.
  recorder.add(Event{9 * kSecond, 0, events::SlavesOutOfSync{500, 1}});
  recorder.add(Event{9 * kSecond + 2 * kMillisecond, 1, events::SlaveLost{}});
  recorder.add(Event{10 * kSecond, 2, events::SlavesOutOfSync{500, 1}});
  recorder.add(Event{12 * kSecond, 1, events::SlaveLost{}});
  EXPECT_EQ(recorder.history().slave_losses.size(), 2U);
}

TEST_F(RunHistoryTest, ALossBehindWhoComesJustThenIsAChangedWayToo) {
  recorder.add(Event{kSecond, -1, events::Online{}});
  recorder.add(Event{8 * kSecond, 2, events::SlavesOutOfSync{562, 1}});
  recorder.add(Event{8 * kSecond + 4 * kMillisecond, 1, events::SlaveFound{}});
  EXPECT_TRUE(recorder.history().slave_losses.empty());
  EXPECT_EQ(recorder.history().way_changes.size(), 1U);
  // No way is as long as that.
  recorder.add(Event{9 * kSecond, 2, events::SlavesOutOfSync{250'000, 1}});
  recorder.add(Event{9 * kSecond + 4 * kMillisecond, 1, events::SlaveFound{}});
  EXPECT_EQ(recorder.history().slave_losses.size(), 1U);
}

TEST_F(RunHistoryTest, CallsAClockOffOnlyAfterItWasNear) {
  auto reading = sample(kSecond);
  reading.slave_position = 1;
  reading.slave_deviation_ns = 900'000;
  add(reading);
  EXPECT_TRUE(recorder.history().slaves[1].off.empty()) << "it was still being set up";
  reading.slave_deviation_ns = 20;
  add(reading);
  reading.slave_deviation_ns = -900'000;
  add(reading);
  EXPECT_EQ(recorder.history().slaves[1].off.largest(), 900'000);
}

/// One slave that stays behind keeps the master's state below OP for good.
TEST_F(RunHistoryTest, WhatHappensBehindAStartUpThatEndedBelowOpCounts) {
  auto reading = sample(kSecond, AlState::kSafeop);
  reading.slave_position = 1;
  reading.slave_deviation_ns = 20;
  recorder.add(Event{kSecond, 1, events::SlavesOutOfSync{900, 1}});
  add(reading);
  EXPECT_TRUE(recorder.history().slave_losses.empty()) << "on the way";
  EXPECT_FALSE(recorder.history().slaves[1].was_near);
  recorder.add(Event{2 * kSecond, -1, events::Online{}});
  add(reading);
  recorder.add(Event{3 * kSecond, 1, events::SlavesOutOfSync{970'000, 1}});
  EXPECT_EQ(recorder.history().slave_losses.size(), 1U);
  EXPECT_TRUE(recorder.history().slaves[1].was_near);
  EXPECT_FALSE(recorder.history().reached_op);
}

TEST_F(RunHistoryTest, FollowsASlaveThatGoesAndComesBack) {
  recorder.add(Event{kSecond, 0, events::CableChanged{1, 1, false}});
  recorder.add(Event{kSecond, 1, events::SlaveLost{}});
  EXPECT_TRUE(recorder.history().slaves[1].absent);
  ASSERT_TRUE(recorder.history().slaves[1].cable);
  EXPECT_EQ(recorder.history().slaves[1].cable->near, 0);
  recorder.add(Event{4 * kSecond, 0, events::CableChanged{1, 1, true}});
  recorder.add(Event{4 * kSecond, 1, events::SlaveFound{}});
  const auto& slave = recorder.history().slaves[1];
  EXPECT_FALSE(slave.absent);
  EXPECT_FALSE(slave.cable);
  ASSERT_EQ(slave.absences.list().size(), 1U);
  EXPECT_EQ(slave.absences.list()[0].to - slave.absences.list()[0].from, 3 * kSecond);
}

TEST_F(RunHistoryTest, ARefusedTryToLeadASlaveUpIsNoFurtherFall) {
  constexpr std::uint16_t kFallen = 0x14;  // SAFEOP with an error
  add(sample(kSecond));
  recorder.add({2 * kSecond, 1, events::StateChanged{AlState::kOp, AlState::kSafeop}});
  recorder.add({2 * kSecond, 1, events::AlStatusError{kFallen, 0x1A}});
  for (int i = 0; i < 3; ++i) recorder.add({(3 + i) * kSecond, 1, events::AlStatusError{kFallen, 0x1D}});
  EXPECT_EQ(recorder.history().slaves[1].falls.size(), 1U);
  EXPECT_EQ(recorder.history().slaves[1].fall->al_status_code, 0x1D) << "the last one is what it is in now";
  recorder.add({8 * kSecond, 1, events::StateChanged{AlState::kNone, AlState::kSafeop}});
  recorder.add({8 * kSecond, 1, events::AlStatusError{kFallen, 0x1B}});
  EXPECT_EQ(recorder.history().slaves[1].falls.size(), 2U) << "it may have been in OP before it was lost";
}

TEST_F(RunHistoryTest, CountsSyncLossesInOpAlone) {
  recorder.add(Event{kSecond, 2, events::SlavesOutOfSync{500, 1}});
  EXPECT_TRUE(recorder.history().slave_losses.empty()) << "still coming up";
  add(sample(2 * kSecond));
  recorder.add(Event{3 * kSecond, 2, events::SlavesOutOfSync{500, 1}});
  recorder.add(Event{5 * kSecond, -1, events::SlavesInSync{5}});
  ASSERT_EQ(recorder.history().slave_losses.size(), 1U);
  EXPECT_EQ(recorder.history().slave_losses[0].slave, 2);
  EXPECT_EQ(recorder.history().slave_losses[0].back, 5 * kSecond);
  EXPECT_EQ(recorder.history().slave_losses[0].obstacle, dc::SyncObstacle::kNone);
  recorder.add(Event{6 * kSecond, -1, events::SlavesOutOfSync{20'000, 4}});
  ASSERT_EQ(recorder.history().slave_losses.size(), 2U);
  EXPECT_EQ(recorder.history().slave_losses[1].obstacle, dc::SyncObstacle::kClockStep) << "what they all follow moved";
}

TEST_F(RunHistoryTest, HowFarTheExternalClockWasAwayIsTheMostOfIt) {
  add(sample(kSecond));
  recorder.add(Event{2 * kSecond, -1, events::MasterOutOfSync{4'100, dc::SyncObstacle::kExternalClock}});
  Snapshot snapshot;
  for (const std::int32_t away : {5'000, -90'000, 20'000}) {
    snapshot.dcm.external_error_ns = away;
    recorder.add(snapshot);
  }
  recorder.add(Event{3 * kSecond, -1, events::MasterInSync{}});
  snapshot.dcm.external_error_ns = 100'000;
  recorder.add(snapshot);
  ASSERT_EQ(recorder.history().master_losses.size(), 1U);
  EXPECT_EQ(recorder.history().master_losses[0].size, -90'000);
}

TEST_F(RunHistoryTest, KnowsFromWhenToWhenFirmwareWasSilent) {
  Snapshot snapshot;
  snapshot.slaves.resize(3);
  snapshot.slaves[2].evidence.pdi_silent = true;
  for (int i = 0; i <= 20; ++i) {
    snapshot.time = 5 * kSecond + i * 100 * kMillisecond;
    recorder.add(snapshot);
  }
  snapshot.slaves[2].evidence.pdi_silent = false;
  snapshot.time = 8 * kSecond;
  recorder.add(snapshot);
  EXPECT_TRUE(recorder.history().slaves[1].pdi_silent.empty());
  ASSERT_EQ(recorder.history().slaves[2].pdi_silent.list().size(), 1U);
  EXPECT_EQ(recorder.history().slaves[2].pdi_silent.first(), 5 * kSecond);
  EXPECT_EQ(recorder.history().slaves[2].pdi_silent.last(), 7 * kSecond);
}

TEST_F(RunHistoryTest, FramesThatCameLateAreNotLost) {
  auto missed = sample(kSecond);
  missed.flags |= CycleSample::kFrameLost;
  missed.frames_lost = 2;
  add(missed);
  Snapshot snapshot;
  snapshot.late_frames = 1;
  recorder.add(snapshot);
  EXPECT_EQ(recorder.history().lost_frames.count(), 1U);
  recorder.add(snapshot);
  EXPECT_EQ(recorder.history().lost_frames.count(), 1U) << "each is taken back once";
}

TEST_F(RunHistoryTest, TakesNoEventOfASlaveThatIsNotConfigured) {
  recorder.add(Event{kSecond, 7, events::SlaveLost{}});
  recorder.add(Event{kSecond, 7, events::CableChanged{0, 9, false}});
  recorder.add(Event{kSecond, 5, events::PortErrors{9, 1, 1}});
  for (const auto& slave : recorder.history().slaves) EXPECT_TRUE(slave.absences.empty());
}

/// A slave that falls early takes the master's state down with it: how late the frames are is seen all the same.
TEST_F(RunHistoryTest, KeepsTheLatenessOfFramesAfterAFallFromOp) {
  know_grid();
  const auto add_many = [&](AlState state, int count) {
    for (int i = 0; i < count; ++i) {
      auto late = sample(kSecond + i * config.cycle_time(), state);
      late.flags |= CycleSample::kReferenceValid;
      late.reference_time = 10 * kSecond + i * config.cycle_time() + 300 * kMicrosecond;
      late.wake_lateness_ns = 300'000;
      add(late);
    }
  };
  add_many(AlState::kSafeop, 50);
  EXPECT_EQ(recorder.history().frame_lateness.count(), 0U) << "the schedule is still finding its place";
  add_many(AlState::kOp, 20);
  add_many(AlState::kSafeop, 2000);
  EXPECT_EQ(recorder.history().frame_lateness.count(), 2020U);
  add_many(AlState::kPreop, 10);
  EXPECT_EQ(recorder.history().frame_lateness.count(), 2020U);
}

/// With a reference clock that has stepped all frames are off the grid, and none is late.
TEST_F(RunHistoryTest, AGridThatIsElsewhereIsNoLatenessOfFrames) {
  know_grid();
  const auto add_many = [&](SyncState state, Nanoseconds off) {
    for (int i = 0; i < 100; ++i) {
      auto one = sample(kSecond + i * config.cycle_time(), AlState::kOp);
      one.flags |= CycleSample::kReferenceValid;
      one.reference_time = 10 * kSecond + i * config.cycle_time() + off;
      one.wake_lateness_ns = 2'000;
      one.master_sync = state;
      add(one);
    }
  };
  add_many(SyncState::kInSync, 2 * kMicrosecond);
  add_many(SyncState::kOutOfSync, 200 * kMicrosecond);
  add_many(SyncState::kInSync, 200 * kMicrosecond);  // until it is known
  EXPECT_EQ(recorder.history().frame_lateness.count(), 200U);
}

TEST(Spells, WhatIsTakenBackIsGoneFromTheLatestOfThem) {
  Spells spells;
  spells.note(kSecond, 4);
  spells.note(3 * kSecond, 3);
  spells.take_back(5);
  EXPECT_EQ(spells.count(), 2U);
  EXPECT_EQ(spells.list()[0].count, 2U);
  EXPECT_EQ(spells.list()[1].count, 0U);
  spells.take_back(9);
  EXPECT_EQ(spells.count(), 0U);
}

TEST_F(RunHistoryTest, ToWhichSideAClockWasOffFirstStays) {
  recorder.add(Event{kSecond, -1, events::Online{}});
  auto reading = sample(kSecond);
  reading.slave_position = 1;
  for (const std::int32_t deviation : {20, -9'000, 8'000}) {
    reading.send_time += kSecond;
    reading.slave_deviation_ns = deviation;
    add(reading);
  }
  EXPECT_EQ(recorder.history().slaves[1].first_off_ns, -9'000);
  EXPECT_EQ(recorder.history().slaves[1].off.largest(), 9'000);
}

TEST_F(RunHistoryTest, OnlyFramesThatWereLateAreLate) {
  auto late = sample(kSecond);
  late.late_by_ns = 77;
  add(late);
  EXPECT_TRUE(recorder.history().late_frames.empty()) << "of a frame that was not it says nothing";
  late.flags = CycleSample::kFrameLate;
  add(late);
  EXPECT_EQ(recorder.history().late_frames.count(), 1U);
  EXPECT_EQ(recorder.history().late_frames.largest(), 77);
}

TEST_F(RunHistoryTest, LateInputsLastUntilTheyAreRenewedAgain) {
  recorder.add(Event{kSecond, 1, events::StaleProcessData{false, 0, 16, false}});
  EXPECT_TRUE(recorder.history().slaves[1].late_inputs.empty()) << "an end without a beginning";
  recorder.add(Event{2 * kSecond, 1, events::StaleProcessData{true, 7, 16, false}});
  recorder.add(Event{5 * kSecond, 1, events::StaleProcessData{false, 1, 16, false}});
  const auto& late = recorder.history().slaves[1].late_inputs;
  EXPECT_EQ(late.count(), 1U);
  EXPECT_EQ(late.first(), 2 * kSecond);
  EXPECT_EQ(late.last(), 5 * kSecond);
  EXPECT_TRUE(recorder.history().slaves[1].late_outputs.empty());
}

}  // namespace
}  // namespace syncline
