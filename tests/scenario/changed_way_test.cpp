// SPDX-License-Identifier: Apache-2.0
// What a slave that goes does to those behind it, and where frames are lost.
#include <gtest/gtest.h>

#include "tests/support/diagnosed_run.h"
#include "tests/support/sample_devices.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class ChangedWay : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;

  void SetUp() override { machine.network = test::two_axes(); }
  [[nodiscard]] bool told_as_step() const {
    return std::ranges::any_of(machine.events, [](const Event& event) {
      const auto* out = event.as<events::SlavesOutOfSync>();
      return out != nullptr && event.slave < 0 && out->over_limit > 0;
    });
  }
};

/// A branch with one terminal, which frames pass before they come to the drives.
TEST_F(ChangedWay, ThroughABranchIsNoStepOfTheReferenceClock) {
  test::DiagnosedRun branched;
  branched.network.add(test::io8());
  branched.network.add(test::io8());
  branched.network.add(test::servo(), "servo-y");
  branched.network.add(test::servo(), "servo-y");
  branched.network.project.master.dc = machine.network.project.master.dc;
  branched.network.sim.slaves[2].parent = 0;
  branched.network.sim.slaves[2].parent_port = 2;
  auto& off = branched.fault(FaultKind::kSlaveOff, 6 * kSecond, 1);
  off.until = 9 * kSecond;
  branched.run(14 * kSecond);
  EXPECT_TRUE(branched.found(code::kFramesWayChanged, 1)) << branched.said();
  EXPECT_FALSE(std::ranges::any_of(branched.events, [](const Event& event) {
    const auto* out = event.as<events::SlavesOutOfSync>();
    return out != nullptr && event.slave < 0 && out->over_limit > 0;
  })) << "a step of the reference clock";
  EXPECT_FALSE(branched.found(code::kWindowLeft)) << branched.said();
}

TEST_F(ChangedWay, AStepOfTheReferenceClockIsStillToldAsThat) {
  machine.fault(FaultKind::kClockStep, 6 * kSecond, 0).value_ns = 2 * kMillisecond;
  machine.run(10 * kSecond);
  EXPECT_TRUE(told_as_step());
  EXPECT_FALSE(machine.found(code::kFramesWayChanged)) << machine.said();
}

TEST_F(ChangedWay, FramesAreLostBehindTheDriveThatHadItsOutputs) {
  auto& fault = machine.fault(FaultKind::kLoseFrames, 6 * kSecond, 2);
  fault.probability = 0.02;
  fault.until = 11 * kSecond;
  machine.run(12 * kSecond);
  EXPECT_TRUE(machine.found(code::kFramesLostBehind, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFramesLost)) << machine.said();
}

TEST_F(ChangedWay, FramesAreLostInFrontOfDrivesThatMissedThem) {
  auto& fault = machine.fault(FaultKind::kLoseFrames, 6 * kSecond, 1);
  fault.probability = 0.02;
  fault.until = 11 * kSecond;
  machine.run(12 * kSecond);
  EXPECT_TRUE(machine.found(code::kFramesLost)) << machine.said();
  EXPECT_FALSE(machine.found(code::kFramesLostBehind)) << machine.said();
}

}  // namespace
}  // namespace syncline
