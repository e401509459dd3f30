// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "protocol/al_state.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/event_match.h"
#include "tests/support/own_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

/// A coupler-like terminal and two servo axes.
class Diagnosis : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;

  void SetUp() override { test::add_two_axes(machine.network); }
  void lose(Nanoseconds at, std::uint32_t count) { machine.fault(FaultKind::kLoseFrames, at).count = count; }
  [[nodiscard]] const RunReport::Slave& slave(std::size_t position) const { return machine.report.slaves.at(position); }
  [[nodiscard]] bool in_op(std::size_t position) const {
    return al_state_of(slave(position).al_status) == AlState::kOp && (slave(position).al_status & kAlErrorFlag) == 0;
  }
};

TEST_F(Diagnosis, AccusesNobodyOnAHealthyMachine) {
  machine.network.add(sample::own("SL-XE2"), "drive-c");
  machine.network.add(sample::own("SL-6751"), "can-gateway");
  machine.run(12 * kSecond);
  EXPECT_EQ(machine.report.state, AlState::kOp);
  EXPECT_FALSE(machine.accuses()) << machine.said();
  for (const auto& slave : machine.report.history.slaves) {
    EXPECT_TRUE(slave.missed.empty()) << "what it counted on the way to OP is none of it";
  }
}

TEST_F(Diagnosis, KeepsTheMissedEventsThatMadeTheDrivesFall) {
  lose(6500 * kMillisecond, 6);
  machine.run(9 * kSecond);
  for (const std::size_t axis : {1U, 2U}) {
    EXPECT_FALSE(in_op(axis));
    const auto& missed = *slave(axis).sm2_missed;
    EXPECT_GE(missed.missed, 3U);
    EXPECT_GE(missed.integrator_highest, 9U);
    EXPECT_GT(missed.computed, 0U) << "the drive's own counter ended with OP";
    EXPECT_TRUE(machine.found(code::kSlaveFellByMisses, static_cast<int>(axis))) << machine.said();
  }
}

TEST_F(Diagnosis, NamesLostFramesAsTheCauseOfMissedEvents) {
  for (int i = 0; i < 6; ++i) lose(5 * kSecond + i * 400 * kMillisecond, 1);
  machine.run(9 * kSecond);
  for (const int axis : {1, 2}) EXPECT_TRUE(machine.found(code::kMissedByLostFrames, axis)) << machine.said();
  EXPECT_TRUE(machine.found(code::kFramesLostInFront, 1)) << machine.said();
  EXPECT_EQ(slave(1).sm2_missed->missed, 6U);
  EXPECT_EQ(slave(1).sm2_missed->by_cause[0], 6U);
  EXPECT_EQ(slave(1).sm2_missed->integrator_highest, 3U);
}

TEST_F(Diagnosis, CallsNoFrameLostThatCameBehindItsCycle) {
  for (int i = 0; i < 6; ++i) {
    const auto from = 5 * kSecond + i * 400 * kMillisecond;
    machine.hold_frames(from, from + kMillisecond, 1300 * kMicrosecond);
  }
  machine.run(9 * kSecond);
  EXPECT_EQ(machine.report.lost_frames, 0U);
  EXPECT_GE(machine.report.late_frames, 6U);
  for (const int axis : {1, 2}) {
    const auto& missed = *slave(static_cast<std::size_t>(axis)).sm2_missed;
    EXPECT_GE(missed.missed, 6U);
    EXPECT_EQ(missed.by_cause[static_cast<std::size_t>(dc::MissCause::kFrameLost)], 0U);
    EXPECT_TRUE(machine.found(code::kMissedByHeldFrames, axis)) << machine.said();
  }
}

TEST_F(Diagnosis, NeverComputesAboveTheLimitOfADriveInOp) {
  for (int i = 0; i < 200; ++i) lose(4500 * kMillisecond + i * 5 * kMillisecond + 200 * kMicrosecond, 1);
  machine.run(7 * kSecond);
  for (const std::size_t axis : {1U, 2U}) {
    EXPECT_TRUE(in_op(axis));
    EXPECT_EQ(slave(axis).sm2_missed->missed, 200U);
    EXPECT_EQ(slave(axis).sm2_missed->integrator_highest, 3U);
  }
}

TEST(DiagnosisOfOneDrive, SaysByHowMuchSync0ComesTooEarly) {
  test::DiagnosedRun machine;
  machine.network.add(test::io8());
  machine.network.add(sample::own("SL-XE2"), "drive-c");
  auto& shift = machine.network.project.slaves[1].dc.sync0.shift;
  shift = -640 * kMicrosecond;
  machine.run(8 * kSecond);
  ASSERT_TRUE(machine.found(code::kShiftTooShort, 1)) << machine.said();
  const auto found = std::ranges::find(machine.findings, code::kShiftTooShort, &Finding::code);
  const auto more = std::ranges::find(found->figures, "more", &Figure::name)->value;
  *shift += more;
  test::DiagnosedRun mended;
  mended.network = machine.network;
  mended.run(8 * kSecond);
  EXPECT_FALSE(mended.found(code::kShiftTooShort)) << "what it advises is enough: " << mended.said();
}

/// Thousands of outputs that are too late are not the doing of one frame that is held up and makes it miss an event.
TEST(DiagnosisOfOneDrive, SaysThatAlsoWhereAFrameWasHeldUp) {
  for (const auto longer : {988 * kMicrosecond, 993 * kMicrosecond}) {
    test::DiagnosedRun machine;
    machine.network.add(test::io8());
    machine.network.add(sample::own("SL-XE2"), "drive-c");
    machine.network.project.slaves[1].dc.sync0.shift = -640 * kMicrosecond;
    machine.network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
    machine.hold_frames(6 * kSecond, 6 * kSecond + kMillisecond, longer);
    machine.run(9 * kSecond);
    EXPECT_TRUE(machine.found(code::kMissedByHeldFrames, 1)) << "else it says nothing\n" << machine.said();
    EXPECT_TRUE(machine.found(code::kShiftTooShort, 1)) << machine.said();
  }
}

TEST(DiagnosisOfAGateway, TellsCanCyclesThatAreSkipped) {
  test::DiagnosedRun machine;
  machine.network.add(test::io8());
  machine.network.add(sample::own("SL-6751"), "can-gateway");
  StartupCommand length{{Transition::kPS}, 0xF800, 7, {0x40, 0x77, 0x1B, 0x00}, false, false, true, 0, "1.8 ms"};
  machine.network.project.slaves[1].startup.push_back(length);
  machine.run(8 * kSecond);
  EXPECT_TRUE(machine.found(code::kGatewayCycleExceeded, 1)) << machine.said();
}

TEST_F(Diagnosis, TellsOfFirmwareThatHangs) {
  machine.fault(FaultKind::kStopApplication, 6 * kSecond, 2).until = 6800 * kMillisecond;
  machine.run(9 * kSecond);
  EXPECT_TRUE(machine.found(code::kFirmwareHung, 2)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFirmwareHung, 1)) << machine.said();
  EXPECT_TRUE(std::ranges::any_of(machine.events, [](const Event& event) {
    return event.slave == 2 && test::with(&events::WatchdogExpired::which, events::WatchdogExpired::Which::kPdi)(event);
  }));
}

TEST_F(Diagnosis, LooksForTheCauseInTheSlaveWhenAllCyclesWereGood) {
  machine.fault(FaultKind::kSilentSync, 6 * kSecond, 1).until = 9 * kSecond;
  machine.run(10 * kSecond);
  EXPECT_TRUE(machine.found(code::kSlaveFellByItself, 1)) << machine.said();
}

TEST_F(Diagnosis, TellsOfFirmwareThatNeedsLongerThanItsCycle) {
  auto& fault = machine.fault(FaultKind::kSlowApplication, 6 * kSecond, 1);
  fault.until = 9 * kSecond;
  fault.value_ns = 1'500'000;
  machine.run(10 * kSecond);
  EXPECT_TRUE(machine.found(code::kFirmwareSlow, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFirmwareSlow, 2)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFirmwareHung)) << machine.said();
}

TEST_F(Diagnosis, NamesThePortWhereFramesWereDamagedFirst) {
  for (int i = 0; i < 8; ++i) machine.fault(FaultKind::kBitErrors, 5 * kSecond + i * 150 * kMillisecond, 1).count = 1;
  machine.run(9 * kSecond);
  EXPECT_TRUE(machine.found(code::kPortErrors, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kPortErrors, 0)) << machine.said();
  EXPECT_FALSE(machine.found(code::kPortErrors, 2)) << machine.said();
  EXPECT_TRUE(machine.found(code::kFramesLostByNoise, 1)) << machine.said();
}

TEST_F(Diagnosis, BlamesTheHostThatStalls) {
  machine.fault(FaultKind::kHostStall, 8 * kSecond).value_ns = 35 * kMillisecond;
  machine.run(12 * kSecond);
  EXPECT_TRUE(machine.found(code::kHostStalled)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFramesLost)) << machine.said();
  EXPECT_TRUE(machine.found(code::kSlaveFellByMisses, 1)) << machine.said();
  EXPECT_GT(slave(1).sm2_missed->by_cause[1], 0U) << "cycles left out";
}

/// Plots and CSV live from the samples: what made a drive fall is in them, although it clears its counter.
TEST_F(Diagnosis, ShowsInTheSamplesWhatItFinds) {
  lose(6 * kSecond, 12);
  machine.run(9 * kSecond);
  for (const std::size_t axis : {1, 2}) {
    ASSERT_GT(slave(axis).sm2_missed->missed, 0U);
    EXPECT_EQ(machine.shown_misses.at(axis), slave(axis).sm2_missed->missed) << machine.said();
  }
}

/// Misses while a drive finds into OP are no fault of the bus, but those that make it fall are the cause.
TEST_F(Diagnosis, CountsTheMissesOfADriveThatFallsJustAfterOp) {
  machine.run(6 * kSecond);
  const auto op = std::ranges::find_if(machine.events, [](const Event& event) {
    return event.slave == 1 && test::with(&events::StateChanged::from, AlState::kSafeop)(event);
  });
  ASSERT_NE(op, machine.events.end());
  // The last ones end after the time that a drive is given to find into OP.
  for (const Nanoseconds after : {40, 86, 90, 95, 99, 130}) {
    test::DiagnosedRun again;
    again.network = machine.network;
    again.fault(FaultKind::kHostStall, op->time - machine.report.history.begin + after * kMillisecond).value_ns =
        12 * kMillisecond;
    again.run(8 * kSecond);
    EXPECT_TRUE(again.found(code::kSlaveFellByMisses, 1)) << after << " ms: " << again.said();
    EXPECT_GE(again.report.slaves[1].sm2_missed->by_cause[1], 3U) << after << " ms: cycles left out";
  }
}

/// Nothing is wrong with the slaves that are accused of it, and none of their values needs a look.
TEST_F(Diagnosis, NamesTheHostWhoseJitterTheModeHandsToTheReferenceClock) {
  auto& dc = machine.network.project.master.dc;
  dc.dcm.mode = DcmMode::kMasterRefClock;
  dc.sync_window.enabled = true;
  machine.network.project.master.cycle_time = 2 * kMillisecond;
  machine.jitter = machine.network.sim.host_jitter = JitterProfile::bad();
  machine.run(15 * kSecond);
  EXPECT_TRUE(machine.found(code::kJitterReachesClock)) << machine.said();
  dc.dcm.mode = DcmMode::kBusShift;
  test::DiagnosedRun other;
  other.network = machine.network;
  other.jitter = machine.jitter;
  other.run(15 * kSecond);
  EXPECT_FALSE(other.found(code::kJitterReachesClock)) << other.said();
}

/// A clock that steps by more than any frame was late has a cause of its own.
TEST_F(Diagnosis, ASteppedClockIsNoJitterOfTheHost) {
  auto& dc = machine.network.project.master.dc;
  dc.dcm.mode = DcmMode::kMasterRefClock;
  dc.sync_window.enabled = true;
  dc.sync_window.exponent = 9;
  machine.fault(FaultKind::kClockStep, 8 * kSecond, 2).value_ns = 500 * kMicrosecond;
  machine.run(12 * kSecond);
  EXPECT_TRUE(machine.found(code::kWindowLeft) || machine.found(code::kSlaveLeftWindow, 2)) << machine.said();
  EXPECT_FALSE(machine.found(code::kJitterReachesClock)) << machine.said();
}

/// Nor is one slave that is off by more than comes through the reference clock's loop.
TEST(JitterOfTheHost, IsNotBlamedForWhatOneClockDoes) {
  for (const auto kind : {FaultKind::kNoisyDelay, FaultKind::kClockStep}) {
    test::DiagnosedRun machine;
    machine.jitter = JitterProfile::quiet();
    for (int i = 0; i < 2; ++i) machine.network.add(test::io8());
    machine.network.add(test::servo(), "servo-y");
    auto& dc = machine.network.project.master.dc;
    dc.dcm.mode = DcmMode::kMasterRefClock;
    dc.sync_window.enabled = true;
    dc.sync_window.exponent = 8;
    auto& fault = machine.fault(kind, 8 * kSecond, kind == FaultKind::kClockStep ? 0 : 1);
    fault.value_ns = kind == FaultKind::kNoisyDelay ? 10'000 : 200 * kMicrosecond;
    fault.period = 10 * kMillisecond;
    fault.until = 14 * kSecond;
    machine.run(20 * kSecond);
    EXPECT_TRUE(machine.accuses()) << static_cast<int>(kind);
    EXPECT_FALSE(machine.found(code::kJitterReachesClock)) << machine.said();
  }
}

TEST_F(Diagnosis, AsksForMoreTimeBetweenFrameAndSync0) {
  machine.jitter = JitterProfile::bad();
  machine.network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
  machine.network.project.master.dc.dcm.set_value = 30 * kMicrosecond;
  machine.run(15 * kSecond);
  EXPECT_TRUE(machine.found(code::kHostLate)) << machine.said();
  EXPECT_TRUE(machine.found(code::kMissedByLateFrames, 0)) << machine.said();
  EXPECT_TRUE(machine.found(code::kSlaveFellByLateFrames, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kShiftTooShort, 1)) << "one cause is told once: " << machine.said();
}

/// A host that is late and stands still: whichever of the two made the drives fall, and however soon, both are told.
TEST_F(Diagnosis, TellsTooLittleTimeBeforeSync0BesideWhatMadeTheDrivesFall) {
  machine.jitter = JitterProfile::bad();
  machine.network.project.master.dc.dcm.mode = DcmMode::kMasterShift;
  machine.network.project.master.dc.dcm.set_value = 30 * kMicrosecond;
  machine.fault(FaultKind::kHostStall, 4 * kSecond).value_ns = 12 * kMillisecond;
  machine.run(9 * kSecond);
  for (const int axis : {1, 2}) {
    const bool fell =
        machine.found(code::kSlaveFellByMisses, axis) || machine.found(code::kSlaveFellByLateFrames, axis);
    const bool tight = machine.found(code::kSync0TooTight, axis) || machine.found(code::kSlaveFellByLateFrames, axis) ||
                       machine.found(code::kShiftTooShort, axis);
    EXPECT_TRUE(fell) << machine.said();
    EXPECT_TRUE(tight) << machine.said();
  }
}

}  // namespace
}  // namespace syncline
