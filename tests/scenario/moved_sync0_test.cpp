// SPDX-License-Identifier: Apache-2.0
// Machines whose SYNC0 does not come where outputs are meant for: what they miss is the clock's doing, and nobody's
// firmware or shift is blamed for it.
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/al_state.h"
#include "tests/support/diagnosed_run.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class MovedSync0 : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;

  void SetUp() override { machine.network = test::two_axes(); }
  void expectNobodyElseBlamed() {
    EXPECT_FALSE(machine.found(code::kMissedUnexplained)) << machine.said();
    EXPECT_FALSE(machine.found(code::kShiftTooShort)) << machine.said();
    EXPECT_FALSE(machine.found(code::kSlaveFellByItself)) << machine.said();
    for (const auto& finding : machine.findings) {
      for (const auto& figure : finding.figures)
        EXPECT_EQ(figure.text.find("firmware"), std::string::npos) << figure.text;
    }
  }
  [[nodiscard]] std::uint32_t missed(std::size_t slave) const {
    return machine.report.slaves.at(slave).sm2_missed->missed;
  }
};

TEST_F(MovedSync0, IsToldByItsStartTimeThatWasReadBack) {
  machine.fault(FaultKind::kWrongStartTime, 0, 1).value_ns = 400'000;
  machine.run(8 * kSecond);
  EXPECT_TRUE(machine.found(code::kSync0Misplaced, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kSync0Misplaced, 2)) << machine.said();
  EXPECT_EQ(machine.report.slaves[1].evidence.sync0.off_ns, 400'000);
  EXPECT_EQ(machine.report.slaves[2].evidence.sync0.off_ns, 0);
  expectNobodyElseBlamed();
}

TEST_F(MovedSync0, ThatNeverComesIsAFinding) {
  machine.fault(FaultKind::kWrongStartTime, 0, 1).value_ns = -10 * kSecond;
  machine.run(8 * kSecond);
  EXPECT_TRUE(machine.found(code::kSync0Never, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kSlaveBehind, 1)) << machine.said();
}

TEST_F(MovedSync0, OfAReferenceClockThatStepsExplainsTheMisses) {
  machine.fault(FaultKind::kClockStep, 6 * kSecond, 0).value_ns = 2 * kMillisecond;
  machine.run(12 * kSecond);
  ASSERT_GT(missed(1) + missed(2), 0U);
  EXPECT_TRUE(machine.found(code::kMissedByMovedClock) || machine.found(code::kSlaveFellByMisses)) << machine.said();
  expectNobodyElseBlamed();
}

TEST_F(MovedSync0, OfASlaveWhoseClockStepsExplainsItsMisses) {
  machine.fault(FaultKind::kClockStep, 6 * kSecond, 1).value_ns = 3 * kMillisecond;
  machine.run(12 * kSecond);
  ASSERT_GT(missed(1), 0U);
  EXPECT_TRUE(machine.found(code::kMissedByMovedClock, 1) || machine.found(code::kSlaveFellByMisses, 1))
      << machine.said();
  EXPECT_FALSE(machine.found(code::kMissedByMovedClock, 2)) << machine.said();
  expectNobodyElseBlamed();
}

/// One that refuses is told by what it says, not by its being behind.
TEST_F(MovedSync0, IsNotSuspectedWhereASlaveRefusesAState) {
  auto& fault = machine.fault(FaultKind::kRefuseState, 0, 1);
  fault.state = AlState::kOp;
  fault.code = 0x001D;
  machine.run(8 * kSecond);
  EXPECT_TRUE(machine.found(code::kSlaveRefused, 1) || machine.found(code::kSlaveFell, 1)) << machine.said();
  EXPECT_FALSE(machine.found(code::kSlaveBehind, 1)) << machine.said();
}

}  // namespace
}  // namespace syncline
