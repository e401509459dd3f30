// SPDX-License-Identifier: Apache-2.0
// What a slave that goes does to those behind it, and where frames are lost.
#include <gtest/gtest.h>

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
