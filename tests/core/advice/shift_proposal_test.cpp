// SPDX-License-Identifier: Apache-2.0
#include "advice/shift_proposal.h"

#include <gtest/gtest.h>

#include "tests/support/sample_devices.h"

namespace syncline {
namespace {

TEST(ShiftProposal, FollowsTheNumberOfNetworks) {
  const auto machine = sample::small_machine();
  EXPECT_EQ(propose_shift(machine, false), (ShiftProposal{DcmMode::kMasterShift, ShiftReason::kOneNetwork}));
  EXPECT_EQ(propose_shift(machine, true), (ShiftProposal{DcmMode::kBusShift, ShiftReason::kSeveralNetworks}));
}

TEST(ShiftProposal, IsNoneWhereNobodyIsSynchronised) {
  auto machine = sample::small_machine();
  machine.master.dc.enabled = false;
  EXPECT_EQ(propose_shift(machine, true), (ShiftProposal{DcmMode::kOff, ShiftReason::kClocksOff}));
  machine.master.dc.enabled = true;
  for (auto& slave : machine.slaves) slave.dc.op_mode.clear();
  EXPECT_EQ(propose_shift(machine, true), (ShiftProposal{DcmMode::kOff, ShiftReason::kNobodyUsesThem}));
}

}  // namespace
}  // namespace syncline
