// SPDX-License-Identifier: Apache-2.0
// What a slave that goes does to those behind it, and where frames are lost.
#include <gtest/gtest.h>

#include "channels/event_text.h"
#include "protocol/frame.h"
#include "support/random.h"
#include "tests/support/cases.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/sample_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class ChangedWay : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;

  void SetUp() override { machine.network = test::two_axes(); }
  /// The terminal and a branch with another one, which frames pass before they come to the two drives.
  void branch() {
    const auto settings = machine.network.project.master;
    machine.network = {};
    machine.network.add(test::io8());
    machine.network.add(test::io8());
    machine.network.add(test::servo(), "servo-y");
    machine.network.add(test::servo(), "servo-y");
    machine.network.project.master = settings;
    machine.network.sim.slaves[2].parent = 0;
    machine.network.sim.slaves[2].parent_port = 2;
  }
  /// So many terminals in a branch of the first one, which frames pass before they come to three drives; the first of
  /// these leads.
  void branch_in_front(std::size_t terminals, DcmMode mode, Nanoseconds cycle) {
    machine.network = {};
    machine.events.clear();
    machine.jitter = JitterProfile::quiet();
    for (std::size_t i = 0; i < terminals + 4; ++i) machine.network.add(i > terminals ? test::servo() : test::io8());
    auto& master = machine.network.project.master;
    master.cycle_time = cycle;
    master.dc.dcm.mode = mode;
    master.dc.sync_window.enabled = true;
    master.dc.reference_clock = static_cast<std::uint16_t>(terminals + 1);
    for (std::size_t i = 0; i <= terminals; ++i) machine.network.project.slaves[i].dc.op_mode = "";
    auto& sim = machine.network.sim.slaves;
    sim[1].parent_port = 3;
    machine.network.project.slaves[1].previous = PreviousPort{0, 3};
    sim[terminals + 1].parent = 0;
    machine.network.project.slaves[terminals + 1].previous = PreviousPort{0, 1};
    Random random(1);
    test::give_random_clocks(machine.network, random);
  }
  void lose_at(int slave) {
    auto& fault = machine.fault(FaultKind::kLoseFrames, 6 * kSecond, slave);
    fault.probability = 0.02;
    fault.until = 11 * kSecond;
    machine.run(12 * kSecond);
  }
  [[nodiscard]] bool told_as_step() const {
    return std::ranges::any_of(machine.events, [](const Event& event) {
      const auto* out = event.as<events::SlavesOutOfSync>();
      return out != nullptr && event.slave < 0 && out->over_limit > 0;
    });
  }
};

TEST_F(ChangedWay, ThroughABranchIsNoStepOfTheReferenceClock) {
  branch();
  machine.fault(FaultKind::kSlaveOff, 6 * kSecond, 1).until = 9 * kSecond;
  machine.run(14 * kSecond);
  EXPECT_TRUE(machine.found(code::kFramesWayChanged, 1)) << machine.said();
  EXPECT_FALSE(told_as_step());
  EXPECT_FALSE(machine.found(code::kWindowLeft)) << machine.said();
  const auto told =
      std::ranges::count_if(machine.events, [](const Event& e) { return e.is<events::FramesWayChanged>(); });
  EXPECT_EQ(told, 2) << "as it goes and as it comes back";
}

/// A line whose end goes and comes back, and a branch behind it. Those in front of it follow as before: not all have
/// moved alike, but all behind it, and they follow again before it is known who went.
TEST(ChangedWayBehind, IsNoStepOfOneOfThem) {
  for (int run = 0; run < test::cases(60); ++run) {
    const int broken = 2 + run % 4;
    test::DiagnosedRun machine;
    machine.network.sim.seed = static_cast<std::uint64_t>(run);
    Random random(static_cast<std::uint64_t>(run));
    for (int i = 0; i < 3; ++i) {
      machine.network.add(test::io8());
      machine.network.add(test::servo(), "servo-y");
    }
    for (int i = 0; i < 12; ++i) machine.network.add(test::servo(), "servo-y");
    auto& master = machine.network.project.master;
    master.cycle_time = 2 * kMillisecond;
    master.dc.dcm.mode = run % 3 == 0 ? DcmMode::kMasterShift : DcmMode::kBusShift;
    master.dc.sync_window.enabled = true;
    master.dc.sync_window.exponent = 9;
    machine.network.sim.slaves[6].parent = 0;
    machine.network.sim.slaves[6].parent_port = 2;
    machine.network.project.slaves[6].previous = PreviousPort{0, 2};
    for (auto& slave : machine.network.sim.slaves) {
      slave.oscillator.ppm = random.uniform(-45, 45);
      slave.cable_m = random.uniform(0.5, 60);
    }
    machine.fault(FaultKind::kCableBreak, 8 * kSecond + static_cast<Nanoseconds>(random.uniform(0, 1e9)), broken)
        .until = 12 * kSecond + static_cast<Nanoseconds>(random.uniform(0, 1e9));
    machine.run(16 * kSecond);
    EXPECT_FALSE(machine.found(code::kWindowLeft)) << broken << " " << machine.said();
  }
}

/// The branch with the reference clock goes and is back before the line has settled at its substitute, which frames
/// reach microseconds later then.
TEST_F(ChangedWay, ToASubstituteIsNoStepOfIt) {
  for (const auto cycle : {kMillisecond, 2 * kMillisecond, 4 * kMillisecond}) {
    for (int number = 0; number < 6; ++number) {
      machine.network = {};
      machine.events.clear();
      for (int i = 0; i < 8; ++i) machine.network.add(i % 4 == 1 ? test::servo() : test::io8(), "generic");
      auto& master = machine.network.project.master;
      master.cycle_time = cycle;
      master.dc.dcm.mode = DcmMode::kMasterShift;
      master.dc.sync_window.enabled = true;
      master.dc.reference_clock = 1;
      machine.network.project.slaves[0].dc.op_mode = "";
      machine.network.sim.slaves[1].parent_port = 3;
      machine.network.project.slaves[1].previous = PreviousPort{0, 3};
      machine.network.sim.slaves[6].parent = 0;
      machine.network.project.slaves[6].previous = PreviousPort{0, 1};
      Random random(static_cast<std::uint64_t>(number));
      test::give_random_clocks(machine.network, random);
      const auto begin = 14 * kSecond + number * 37 * kMillisecond;
      machine.fault(FaultKind::kSlaveOff, begin, 1).until = begin + (50 + 10 * number) * kMillisecond;
      machine.run(17 * kSecond);
      EXPECT_TRUE(std::ranges::any_of(machine.events, [](const Event& event) {
        const auto* change = event.as<events::ReferenceClockChanged>();
        return change != nullptr && change->what == events::ReferenceClockChanged::What::kTookOver;
      }));
      EXPECT_FALSE(std::ranges::any_of(machine.events,
                                       [](const Event& event) {
                                         const auto* out = event.as<events::MasterOutOfSync>();
                                         return out != nullptr && out->obstacle == dc::SyncObstacle::kClockStep;
                                       }))
          << cycle << " " << number << " " << machine.said();
    }
  }
}

/// Asked by its place, the clock that leads is told the time as one that follows, in the frames in which a branch in
/// front of it is gone and nobody knows: nobody told it anything any more, and it ran on with that at 775 ppm.
TEST_F(ChangedWay, OfABranchThatGoesMakesNobodyRunAway) {
  for (const auto cycle : {kMillisecond, 4 * kMillisecond}) {
    for (const std::size_t others : {2U, 8U, 16U}) {
      branch_in_front(others, DcmMode::kMasterShift, cycle);
      machine.fault(FaultKind::kCableBreak, 14 * kSecond, 1).until = 16 * kSecond;
      machine.run(20 * kSecond);
      const auto trouble = [](const Event& e) {
        return e.is<events::DcmError>() || (e.time > 14 * kSecond && e.is<events::MasterOutOfSync>());
      };
      EXPECT_FALSE(std::ranges::any_of(machine.events, trouble)) << others << " " << machine.said();
      EXPECT_TRUE(machine.found(code::kSlaveWasAbsent)) << machine.said();
      EXPECT_FALSE(machine.found(code::kSlaveLeftWindow)) << others << " " << machine.said();
    }
  }
}

/// Forty terminals in front of the reference clock make the way to it 11 us longer. In every mode that was a step of
/// that clock, or a frame that had been held up, and with bus shift and written clocks it moved the machine.
TEST_F(ChangedWay, OfALargeBranchMovesNobody) {
  for (const auto mode :
       {DcmMode::kBusShift, DcmMode::kMasterShift, DcmMode::kMasterRefClock, DcmMode::kLinkLayerRefClock}) {
    for (const auto cycle : {500 * kMicrosecond, kMillisecond, 4 * kMillisecond}) {
      // The host's jitter alone takes slaves out of their window there.
      if (mode == DcmMode::kMasterRefClock && cycle > kMillisecond) continue;
      branch_in_front(40, mode, cycle);
      const auto begin = machine.fault(FaultKind::kCableBreak, 14 * kSecond, 1).at;
      machine.network.sim.faults.back().until = 16 * kSecond;
      machine.run(20 * kSecond);
      for (const auto& event : machine.events) {
        if (event.time < VirtualClock::kDefaultStart + begin) continue;
        EXPECT_FALSE(event.is<events::DcmError>() || event.is<events::MasterOutOfSync>() ||
                     event.is<events::SlavesOutOfSync>())
            << static_cast<int>(mode) << " " << cycle << " " << event_words(event);
      }
      EXPECT_TRUE(machine.found(code::kSlaveWasAbsent)) << machine.said();
      EXPECT_FALSE(machine.found(code::kReferenceWrittenLate)) << machine.said();
      EXPECT_LT(machine.report.slaves.back().deviation_max_ns, 127U) << static_cast<int>(mode) << " " << cycle;
    }
  }
}

/// The terminals' branch parts from the drives at a slave without receive times. Those who follow the first drive are
/// measured from it all the same, at the start and whenever somebody has come.
TEST_F(ChangedWay, ThatNobodyCanMeasureIsOnlyToldOfWhoFollowsOverIt) {
  for (const bool drive_leads : {false, true}) {
    machine.network = {};
    machine.events.clear();
    for (int i = 0; i < 7; ++i) machine.network.add(i > 3 ? test::servo() : test::io8(), i > 3 ? "servo-y" : "generic");
    auto& sim = machine.network.sim.slaves;
    sim[0].dc.system_time = sim[0].dc.receive_times = false;
    machine.network.project.slaves[0].dc.op_mode = "";
    sim[1].parent_port = 3;
    machine.network.project.slaves[1].previous = PreviousPort{0, 3};
    sim[4].parent = 0;
    machine.network.project.slaves[4].previous = PreviousPort{0, 1};
    machine.network.project.master.dc.reference_clock = drive_leads ? 4 : 1;
    machine.fault(FaultKind::kSlaveOff, 6 * kSecond, 3).until = 8 * kSecond;
    machine.run(12 * kSecond);
    std::vector<int> told;
    for (const auto& event : machine.events) {
      if (event.is<events::DelayFinding>()) told.push_back(event.slave);
    }
    EXPECT_GE(std::ranges::count_if(machine.events, [](const Event& e) { return e.is<events::DelaysMeasured>(); }), 2);
    EXPECT_EQ(std::ranges::count(told, 4), drive_leads ? 0 : 3) << "at the start, without it, and with it again";
    EXPECT_EQ(told.size(), drive_leads ? 0U : 3U);
  }
}

/// By its place only where somebody does not know FRMW: a place is another's as soon as somebody in front of it goes.
TEST_F(ChangedWay, TheClockThatLeadsIsAskedByItsStationAddress) {
  for (const bool frmw_unknown : {false, true}) {
    int by_place = 0, by_station = 0;
    machine.network = test::two_axes();
    machine.network.project.slaves[1].device.dc->unknown_frmw = frmw_unknown;
    machine.loses = [&](std::span<const std::uint8_t> sent) {
      std::vector<std::uint8_t> bytes(sent.begin(), sent.end());
      FrameReader frame(bytes);
      bool cyclic = false, places = false, stations = false;
      while (const auto datagram = frame.next()) {
        cyclic = cyclic || is_logical(datagram->header.command);
        places = places || datagram->header.command == Command::kArmw;
        stations = stations || datagram->header.command == Command::kFrmw;
      }
      by_place += cyclic && places ? 1 : 0;
      by_station += cyclic && stations ? 1 : 0;
      return false;
    };
    machine.run(4 * kSecond);
    EXPECT_GT(frmw_unknown ? by_place : by_station, 500);
    EXPECT_LT(frmw_unknown ? by_station : by_place, 20) << "while the master begins";
  }
}

TEST_F(ChangedWay, AStepOfTheReferenceClockIsStillToldAsThat) {
  machine.fault(FaultKind::kClockStep, 6 * kSecond, 0).value_ns = 2 * kMillisecond;
  machine.run(10 * kSecond);
  EXPECT_TRUE(told_as_step());
  EXPECT_FALSE(machine.found(code::kFramesWayChanged)) << machine.said();
}

/// Who has been away for long has nothing to do with it.
TEST_F(ChangedWay, AStepWhileSomebodyIsAwayIsToldAsThat) {
  branch();
  machine.fault(FaultKind::kSlaveOff, 6 * kSecond, 1);
  machine.fault(FaultKind::kClockStep, 10 * kSecond, 0).value_ns = 5 * kMicrosecond;
  machine.run(14 * kSecond);
  EXPECT_TRUE(told_as_step());
}

TEST_F(ChangedWay, FramesAreLostBehindTheDriveThatHadItsOutputs) {
  lose_at(2);
  EXPECT_TRUE(machine.found(code::kFramesLostBehind, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFramesLost)) << machine.said();
}

TEST_F(ChangedWay, FramesAreLostInFrontOfDrivesThatMissedThem) {
  lose_at(1);
  EXPECT_TRUE(machine.found(code::kFramesLostInFront)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFramesLostBehind)) << machine.said();
}

}  // namespace
}  // namespace syncline
