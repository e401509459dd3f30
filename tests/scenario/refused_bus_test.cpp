// SPDX-License-Identifier: Apache-2.0
// What is said of a bus that is not the configured one, and is never operated.
#include <gtest/gtest.h>

#include <utility>

#include "protocol/al_state.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class RefusedBus : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;

  void expect_no_fancy() {
    ASSERT_EQ(machine.report.cycles, 0U);
    for (const auto& event : machine.events) {
      EXPECT_FALSE(event.is<events::SlaveLost>()) << event.slave << ": it answers, it is another one";
    }
    for (const auto& slave : machine.report.slaves) {
      EXPECT_LE(slave.al_status_time, machine.report.history.end) << "read in the future";
      if (!slave.present) {
        EXPECT_EQ(slave.al_status, 0) << "nobody knows the state of who does not answer";
      }
    }
    for (const auto* code : {&code::kSlaveBehind, &code::kSlaveWasAbsent, &code::kSlaveAbsent}) {
      EXPECT_FALSE(machine.found(*code)) << machine.said();
    }
  }
};

/// Only an EEPROM that is read during the start-up shows it.
TEST_F(RefusedBus, SlavesThatHaveChangedPlacesAreThere) {
  machine.network = test::two_axes();
  machine.network.add(test::io8());
  auto& slaves = machine.network.sim.slaves;
  std::swap(slaves[2], slaves[3]);
  std::swap(slaves[2].parent, slaves[3].parent);
  machine.run(kSecond);
  expect_no_fancy();
  for (const auto& slave : machine.report.slaves) EXPECT_TRUE(slave.present) << slave.position;
}

TEST_F(RefusedBus, ASlaveTooFewIsInNoState) {
  machine.network = test::two_axes();
  machine.network.sim.slaves.pop_back();
  machine.run(kSecond);
  expect_no_fancy();
  EXPECT_FALSE(machine.report.slaves[2].present);
  EXPECT_GE(machine.report.history.end, machine.report.history.begin);
}

TEST_F(RefusedBus, ADeviceOfAnotherKindStillAnswers) {
  machine.network = test::two_axes();
  test::SimulatedNetwork other;
  other.add(test::io8());
  auto& slave = machine.network.sim.slaves[1];
  slave.device = other.sim.slaves[0].device;
  slave.behaviour = other.sim.slaves[0].behaviour;
  machine.run(kSecond);
  expect_no_fancy();
}

}  // namespace
}  // namespace syncline
