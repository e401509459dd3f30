// SPDX-License-Identifier: Apache-2.0
// What happened stays told whatever became of it, and nothing is said that the evidence does not hold.
#include <gtest/gtest.h>

#include "protocol/al_state.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/sample_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class KeptEvidence : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;

  void SetUp() override { test::add_two_axes(machine.network); }
  /// The set value that leaves the axis with the least time `room` more than it needs from its outputs to SYNC0.
  void leave(Nanoseconds room) {
    test::DiagnosedRun before;
    before.network = machine.network;
    auto& set_value = machine.network.project.master.dc.dcm.set_value;
    set_value = before.network.project.master.dc.dcm.set_value = 200 * kMicrosecond;
    before.run(6 * kSecond);
    Nanoseconds least = INT64_MAX;
    for (const auto& slave : before.report.slaves) {
      if (slave.evidence.calc_and_copy_ns > 0)
        least = std::min(least, *slave.sync0_margin - slave.evidence.calc_and_copy_ns);
    }
    *set_value += room - least;
  }
};

/// Readings of the slaves that went with the process data would make it later by what they are long, in some cycles.
TEST_F(KeptEvidence, IsNotGatheredAtTheCostOfOutputsThatAreJustInTime) {
  leave(1500);
  machine.run(10 * kSecond);
  for (const std::size_t axis : {1U, 2U}) {
    EXPECT_EQ(machine.report.slaves[axis].sm2_missed->missed, 0U) << machine.said();
    EXPECT_GT(machine.report.slaves[axis].evidence.ports_time, 0) << "and it is gathered";
    EXPECT_FALSE(machine.found(code::kShiftTooShort, static_cast<int>(axis))) << machine.said();
  }
}

/// They fall within a few cycles, before anybody has read a counter, and clear it.
TEST_F(KeptEvidence, ADriveThatFallsAtOnceHasMissedWhatItsLimitProves) {
  for (auto& slave : machine.network.project.slaves) {
    if (slave.device.mailbox)
      slave.startup.push_back({{Transition::kPS}, 0x10F1, 2, {3, 0}, false, false, true, 0, "limit"});
  }
  leave(-6'000);
  machine.run(10 * kSecond);
  for (const std::size_t axis : {1U, 2U}) {
    const auto& missed = *machine.report.slaves[axis].sm2_missed;
    EXPECT_GE(missed.missed, 1U);
    EXPECT_EQ(missed.limit, 3U);
    EXPECT_GE(missed.integrator_highest, missed.limit);
    EXPECT_TRUE(machine.found(code::kSlaveFellByLateFrames, static_cast<int>(axis))) << machine.said();
  }
}

/// A plug that is loose for two cycles: whoever is behind it goes on, and knows best what it missed.
TEST_F(KeptEvidence, WhoWasAwayAndIsInOpStillMissedWhatItsCounterSays) {
  auto& pulled = machine.fault(FaultKind::kCableBreak, 6 * kSecond + 300 * kMicrosecond, 1);
  pulled.until = pulled.at + 2 * kMillisecond;
  machine.run(12 * kSecond);
  for (const std::size_t axis : {1U, 2U}) {
    ASSERT_FALSE(machine.report.history.slaves[axis].absences.empty()) << machine.said();
    ASSERT_EQ(al_state_of(machine.report.slaves[axis].al_status), AlState::kOp);
    const auto& missed = *machine.report.slaves[axis].sm2_missed;
    EXPECT_EQ(missed.missed, 2U) << machine.said();
    EXPECT_EQ(missed.computed, 0U);
    EXPECT_FALSE(missed.at_least);
    EXPECT_LT(missed.integrator_highest, missed.limit);
  }
}

TEST_F(KeptEvidence, AFallIsToldWhenItIsOver) {
  machine.network.add(test::servo(), "servo-y");
  machine.fault(FaultKind::kLoseFrames, 6 * kSecond).count = 6;
  machine.fault(FaultKind::kSlaveOff, 8 * kSecond, 2).until = 9 * kSecond;
  machine.run(16 * kSecond);
  // Who was away is led up again, and so is who was behind it; the first axis stays where it fell to.
  for (const int axis : {2, 3}) EXPECT_TRUE(machine.found(code::kSlaveHadFallen, axis)) << machine.said();
  EXPECT_TRUE(machine.found(code::kSlaveFellByMisses, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kSlaveHadFallen, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kSlaveClockOff)) << "who comes back finds its time again: " << machine.said();
}

TEST_F(KeptEvidence, AFallIsToldOfASlaveThatIsGone) {
  machine.fault(FaultKind::kLoseFrames, 6 * kSecond).count = 6;
  machine.fault(FaultKind::kSlaveOff, 8 * kSecond, 2).until = 30 * kSecond;
  machine.run(12 * kSecond);
  EXPECT_TRUE(machine.found(code::kSlaveAbsent, 2) || machine.found(code::kSlaveAbsentBehindCable, 2));
  EXPECT_TRUE(machine.found(code::kSlaveHadFallen, 2)) << machine.said();
}

TEST_F(KeptEvidence, WhatAnAbsenceMadeOfASlaveIsNoFall) {
  machine.fault(FaultKind::kSlaveOff, 6 * kSecond, 1).until = 7 * kSecond;
  machine.run(14 * kSecond);
  ASSERT_EQ(machine.report.state, AlState::kOp) << machine.said();
  EXPECT_FALSE(machine.found(code::kSlaveHadFallen)) << machine.said();
}

TEST_F(KeptEvidence, NoPlaceIsNamedWhereTwoFramesWereLostSomewhere) {
  machine.fault(FaultKind::kLoseFrames, 6 * kSecond, 2).count = 2;
  machine.run(9 * kSecond);
  EXPECT_TRUE(machine.found(code::kFramesLost)) << "one had its outputs, the other not: " << machine.said();
  EXPECT_FALSE(machine.found(code::kFramesLostInFront)) << machine.said();
}

TEST_F(KeptEvidence, FramesThatReachNobodyAreLostInFrontOfTheFirstThatCounts) {
  machine.fault(FaultKind::kLoseFrames, 6 * kSecond).count = 2;
  machine.run(9 * kSecond);
  EXPECT_TRUE(machine.found(code::kFramesLostInFront, 1)) << machine.said();
}

TEST_F(KeptEvidence, ADelayThatCannotBeIsAnError) {
  auto& fault = machine.fault(FaultKind::kStuckPortTime, 0, 1);
  fault.port = 1;
  machine.run(8 * kSecond);
  EXPECT_TRUE(machine.found(code::kDelayNotMeasured)) << machine.said();
}

TEST_F(KeptEvidence, FirmwareThatStillHangsIsToldSo) {
  machine.network.add(test::io8());  // without a mailbox that could stay silent
  machine.fault(FaultKind::kStopApplication, 6 * kSecond, 3).until = 60 * kSecond;
  machine.run(10 * kSecond);
  EXPECT_TRUE(machine.found(code::kFirmwareHangs, 3)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFirmwareHung, 3)) << machine.said();
}

class HotConnectEvidence : public KeptEvidence {
 protected:
  void SetUp() override {
    KeptEvidence::SetUp();
    machine.network.add(test::servo(), "servo-y");
    machine.network.project.slaves[2].alias = machine.network.sim.slaves[2].alias = 77;
    machine.network.project.slaves[2].hot_connect = "Trolley";
  }
};

TEST_F(HotConnectEvidence, AGroupThatComesAndGoesIsNoFault) {
  machine.fault(FaultKind::kCableBreak, 6 * kSecond, 2).until = 8 * kSecond;
  machine.run(14 * kSecond);
  EXPECT_FALSE(machine.accuses()) << machine.said();
}

TEST_F(HotConnectEvidence, AMemberThatIsMissingAloneIs) {
  machine.fault(FaultKind::kSlaveOff, 6 * kSecond, 3).until = 60 * kSecond;
  machine.run(10 * kSecond);
  EXPECT_TRUE(machine.found(code::kSlaveAbsent, 3) || machine.found(code::kSlaveAbsentBehindCable, 3))
      << machine.said();
}

TEST_F(KeptEvidence, AWorkingCounterThatIsNeverRightIsAnError) {
  machine.change = [](NetworkConfig& config) {
    for (auto& frame : config.cyclic.front().frames) {
      for (auto& command : frame.commands) {
        if (is_logical(command.command) && command.expected_wkc) ++*command.expected_wkc;
      }
    }
  };
  machine.run(9 * kSecond);
  EXPECT_TRUE(machine.found(code::kWorkingCounterNeverRight)) << machine.said();
  EXPECT_FALSE(machine.found(code::kWorkingCounter)) << machine.said();
}

TEST_F(KeptEvidence, TheLargestDeviationIsAsLargeAsTheOneThatIsTold) {
  machine.network.project.master.dc.sync_window.enabled = true;
  machine.fault(FaultKind::kClockStep, 7 * kSecond, 2).value_ns = 48'000;
  machine.run(12 * kSecond);
  std::int64_t told = 0;
  for (const auto& event : machine.events) {
    if (const auto* out = event.as<events::SlavesOutOfSync>()) told = std::max(told, out->deviation_ns);
  }
  ASSERT_GT(told, 40'000) << machine.said();
  EXPECT_GE(machine.report.deviation_max_ns.value_or(0), told);
}

}  // namespace
}  // namespace syncline
