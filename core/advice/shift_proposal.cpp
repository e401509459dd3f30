// SPDX-License-Identifier: Apache-2.0
#include "advice/shift_proposal.h"

#include <algorithm>

#include "config/project.h"
#include "config/sync0_cycle.h"

namespace syncline {

ShiftProposal propose_shift(const Project& project, bool several_networks) {
  if (!project.master.dc.enabled) return {DcmMode::kOff, ShiftReason::kClocksOff};
  const bool used = std::any_of(project.slaves.begin(), project.slaves.end(), [](const SlaveSettings& slave) {
    const auto* mode = compiler::selected_op_mode(slave);
    return mode != nullptr && mode->assign_activate != 0;
  });
  if (!used) return {DcmMode::kOff, ShiftReason::kNobodyUsesThem};
  return several_networks ? ShiftProposal{DcmMode::kBusShift, ShiftReason::kSeveralNetworks}
                          : ShiftProposal{DcmMode::kMasterShift, ShiftReason::kOneNetwork};
}

}  // namespace syncline
