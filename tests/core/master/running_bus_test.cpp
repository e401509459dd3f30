// SPDX-License-Identifier: Apache-2.0
#include "tests/core/master/operation_bed.h"

/// What happens to a bus that runs: frames that are lost or late, slaves that go or fall, a host that stands still.
namespace syncline {
namespace {

class RunningBusTest : public test::OperationBed {};

/// Somebody stops its SYNC0; nobody has asked it to leave OP.
TEST_F(RunningBusTest, TellsASlaveThatLeavesOpByItself) {
  go_online();
  run(100 * kMillisecond);
  events.clear();
  ASSERT_TRUE(link->set(1, reg::kActivation, std::uint8_t{0}));
  run(500 * kMillisecond);
  EXPECT_EQ(snapshot.state, AlState::kSafeop);
  EXPECT_EQ(snapshot.slaves[1].al_status, 0x14);
  EXPECT_EQ(snapshot.slaves[1].al_status_code, 0x002C);
  EXPECT_EQ(count(kind_of<events::AlStatusError>), 1U);
  run(kSecond);
  EXPECT_EQ(count(kind_of<events::AlStatusError>), 1U);  // once
}

TEST_F(RunningBusTest, TellsLostSlavesAndWrongCounters) {
  fault(FaultKind::kSlaveOff, 2).until = kLater + 50 * kMillisecond;
  go_online();
  run_until(kLater - kMillisecond);
  events.clear();
  const auto before = clock.now();
  run(50 * kMillisecond);
  EXPECT_EQ(count(kind_of<events::SlaveLost>), 1U);
  EXPECT_NEAR(static_cast<double>(snapshot.slaves[2].absent_since - before), 3e6, 2e6);
  // Wrong until the lost slave is known as lost, then less is expected.
  EXPECT_EQ(count(kind_of<events::WkcError>), 2U);
  EXPECT_LE(snapshot.wkc_errors, 3U);
  EXPECT_EQ(count(kind_of<events::WkcExpected>), 1U);
  EXPECT_EQ(samples.back().wkc_expected, 3);
  EXPECT_EQ(samples.back().wkc_received, samples.back().wkc_expected);
  EXPECT_FALSE(snapshot.slaves[2].present);
  run_to(AlState::kOp);
  run(100 * kMillisecond);
  EXPECT_EQ(count(kind_of<events::SlaveFound>), 1U);
  EXPECT_TRUE(snapshot.slaves[2].present);
  EXPECT_EQ(snapshot.slaves[2].absent_since, 0);
  EXPECT_EQ(samples.back().wkc_expected, 6);
  EXPECT_EQ(samples.back().flags & CycleSample::kWkcError, 0);
}

TEST_F(RunningBusTest, CountsLostFramesAndGoesOn) {
  go_online();
  link->lose(5);
  run(200 * kMillisecond);
  EXPECT_EQ(snapshot.lost_frames, 5U);
  EXPECT_EQ(sum<events::FramesLost>(), 5);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_EQ(snapshot.wkc_errors, 0U);
}

TEST_F(RunningBusTest, EachLostFrameIsInExactlyOneEvent) {
  go_online();
  samples.clear();
  const int losses[] = {1, 2, 1, 3, 2, 7, 1};
  int lost = 0;
  for (const int frames : losses) {
    link->lose(frames);
    run(30 * kMillisecond);
    lost += frames;
  }
  run(200 * kMillisecond);
  EXPECT_EQ(snapshot.lost_frames, static_cast<std::uint64_t>(lost));
  EXPECT_EQ(sum<events::FramesLost>(), lost);
  int in_samples = 0;
  for (const auto& sample : samples) in_samples += sample.frames_lost;
  EXPECT_EQ(in_samples, lost);
}

TEST_F(RunningBusTest, LossesAreToldToTheEndOfOperation) {
  go_online();
  link->lose(2);
  run(4 * kMillisecond);
  link->lose(3);
  run(4 * kMillisecond);
  go_offline();
  EXPECT_EQ(snapshot.lost_frames, 5U);
  EXPECT_EQ(sum<events::FramesLost>(), 5);
}

TEST_F(RunningBusTest, AFrameThatComesAfterItsDeadlineIsLateAndNotLost) {
  auto& held = fault(FaultKind::kHoldFrames, -1);
  held.until = kLater + 2 * kMillisecond;
  held.value_ns = 2'500'000;
  go_online();
  run_until(kLater - kMillisecond);
  samples.clear();
  run(200 * kMillisecond);
  EXPECT_EQ(snapshot.lost_frames, 0U);
  EXPECT_GE(snapshot.late_frames, 2U);
  EXPECT_EQ(count(kind_of<events::FramesLost>), 0U);
  EXPECT_EQ(sum<events::FramesLate>(), static_cast<std::int64_t>(snapshot.late_frames));
  const auto late =
      std::ranges::find_if(samples, [](const auto& s) { return (s.flags & CycleSample::kFrameLate) != 0; });
  ASSERT_NE(late, samples.end());
  EXPECT_NEAR(late->late_by_ns, 1'700'000, 20'000);
  EXPECT_GE(std::ranges::count_if(samples, [](const auto& s) { return s.frames_lost > 0; }), 1);
}

TEST_F(RunningBusTest, AStandstillOfTheHostIsCyclesLeftOut) {
  go_online();
  samples.clear();
  clock.advance_to(clock.now() + 20'300'000);
  run(200 * kMillisecond);
  EXPECT_NEAR(static_cast<double>(snapshot.skipped_cycles), 20, 1);
  EXPECT_EQ(snapshot.overruns, 1U);
  EXPECT_EQ(sum<events::CyclesLeftOut>(), static_cast<std::int64_t>(snapshot.skipped_cycles));
  const auto told = std::ranges::find_if(events, [](const Event& e) { return e.is<events::CyclesLeftOut>(); });
  ASSERT_NE(told, events.end());
  EXPECT_NEAR(told->as<events::CyclesLeftOut>()->standstill, 20'300'000, kMillisecond);
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.front().skipped_cycles, snapshot.skipped_cycles);
  EXPECT_LT(samples.front().wake_lateness_ns, 500'000);
  // No two frames in one cycle afterwards.
  for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_GT(samples[i].send_time - samples[i - 1].send_time, 499'000);
}

/// Its substitute leads meanwhile; it is in front of that one, or behind it.
TEST_F(RunningBusTest, TheReferenceClockLeadsAgainWhenItIsBack) {
  network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
  network.project.master.dc.sync_window.enabled = true;
  fault(FaultKind::kSlaveOff, 1).until = kLater + kSecond;
  go_online();
  run_until(kLater + 500 * kMillisecond);
  ASSERT_FALSE(snapshot.slaves[1].present);
  run_until(kLater + 6 * kSecond);
  EXPECT_EQ(snapshot.state, AlState::kOp);
  EXPECT_EQ(snapshot.dc.reference_clock, 1);
  EXPECT_TRUE(snapshot.slaves[1].is_reference_clock);
  EXPECT_EQ(snapshot.dc.state, SyncState::kInSync);
}

/// Before it is asked for PREOP. The reference clock, which will lead again, takes the longer one.
TEST_F(RunningBusTest, AClockThatIsBackLearnsAsLongAsItMust) {
  const auto learns = [this](int away) {
    network.sim.faults.clear();
    fault(FaultKind::kSlaveOff, away).until = kLater + kSecond;
    service.reset();
    go_online();
    run_until(kLater);
    events.clear();
    run_until(kLater + 6 * kSecond);
    Nanoseconds found = 0, preop = 0;
    for (const auto& event : events) {
      if (event.slave != away) continue;
      if (event.is<events::SlaveFound>()) found = event.time;
      if (test::with(&events::StateChanged::to, AlState::kPreop)(event)) preop = event.time;
    }
    EXPECT_EQ(snapshot.state, AlState::kOp);
    return preop - found;
  };
  const auto follower = learns(2), home = learns(1);
  EXPECT_GT(follower, 60 * kMillisecond);
  EXPECT_LT(follower, 200 * kMillisecond);
  EXPECT_GT(home, 400 * kMillisecond);
  EXPECT_LT(home, kSecond);
}

TEST_F(RunningBusTest, DoesNotWaitForASlaveThatIsGone) {
  fault(FaultKind::kSlaveOff, 2);
  go_online();
  run_until(kLater + 50 * kMillisecond);
  EXPECT_FALSE(snapshot.slaves[2].present);
  const auto before = clock.now();
  go_offline();
  EXPECT_LT(clock.now() - before, kSecond);
  EXPECT_EQ(al_status(1), 1);
}

}  // namespace
}  // namespace syncline
