// SPDX-License-Identifier: Apache-2.0
#include "advice/clock_candidates.h"

#include <optional>

#include "config/project.h"
#include "config/sync0_cycle.h"

namespace syncline {

std::vector<ClockCandidate> clock_candidates(const Project& project) {
  std::vector<ClockCandidate> candidates;
  std::optional<std::size_t> follower;
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const auto& slave = project.slaves[i];
    const auto* mode = compiler::selected_op_mode(slave);
    ClockCandidate candidate;
    if (!slave.device.dc) {
      candidate.concern = ClockConcern::kNoClock;
    } else if (slave.optional || !slave.hot_connect.empty()) {
      candidate.concern = ClockConcern::kMayBeMissing;
    } else if (follower) {
      candidate = {ClockConcern::kBehindFollower, *follower};
    }
    candidates.push_back(candidate);
    if (!follower && mode != nullptr && mode->assign_activate != 0) follower = i;
  }
  return candidates;
}

}  // namespace syncline
