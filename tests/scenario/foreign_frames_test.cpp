// SPDX-License-Identifier: Apache-2.0
// What other programs send by the master's adapter.
#include <gtest/gtest.h>

#include "tests/support/diagnosed_run.h"
#include "tests/support/small_machines.h"

namespace syncline {
namespace {

class ForeignFrames : public ::testing::Test {
 protected:
  test::DiagnosedRun machine;
  void SetUp() override { machine.network = test::two_axes(); }
};

TEST_F(ForeignFrames, AreToldAsWhatTheyAre) {
  auto& fault = machine.fault(FaultKind::kForeignFrames, 6 * kSecond);
  fault.until = 9 * kSecond;
  fault.period = 10 * kMillisecond;
  machine.run(12 * kSecond);
  EXPECT_TRUE(machine.found(code::kForeignFrames, 0)) << machine.said();
  EXPECT_FALSE(machine.found(code::kPortErrors)) << machine.said();
}

/// 0x030C stops at 255: it is cleared then, and counts on.
TEST_F(ForeignFrames, AreCountedBeyondTheEndStopOfTheCounter) {
  auto& fault = machine.fault(FaultKind::kForeignFrames, 6 * kSecond);
  fault.count = 600;
  fault.period = 10 * kMillisecond;
  machine.run(14 * kSecond);
  const auto& counted = machine.report.slaves.front().evidence.processing_unit_errors;
  EXPECT_TRUE(counted.at_least);
  EXPECT_GT(counted.total, 500U);
  EXPECT_LE(counted.total, 600U);
}

/// What counts in the same register, and is none.
TEST_F(ForeignFrames, ADamagedFrameOrAPluggedCableIsNone) {
  auto& noise = machine.fault(FaultKind::kBitErrors, 6 * kSecond, 0);
  noise.probability = 0.05;
  noise.until = 8 * kSecond;
  machine.fault(FaultKind::kCableBreak, 9 * kSecond, 1).until = 10 * kSecond;
  machine.run(16 * kSecond);
  EXPECT_FALSE(machine.found(code::kForeignFrames)) << machine.said();
}

TEST_F(ForeignFrames, AQuietMachineHasNone) {
  machine.run(12 * kSecond);
  EXPECT_FALSE(machine.accuses()) << machine.said();
}

}  // namespace
}  // namespace syncline
