// SPDX-License-Identifier: Apache-2.0
#include "ui/session/running_slave.h"

#include "ui/session/workspace.h"

namespace syncline::ui {
AlState RunningSlave::state() const { return present() ? al_state_of(status->al_status) : AlState::kNone; }

std::optional<RunningSlave> runningSlave(Workspace& workspace, int slave) {
  const auto& live = workspace.live();
  if (live.requests() == nullptr || live.record() == nullptr) return std::nullopt;
  const int position = workspace.runningSlaves().positionOf(slave);
  if (position < 0) return std::nullopt;
  const auto at = static_cast<std::size_t>(position);
  RunningSlave result;
  result.position = static_cast<std::uint16_t>(position);
  result.config = &live.record()->config().slaves[at];
  const auto& statuses = live.snapshot().slaves;
  if (live.snapshot().online && at < statuses.size()) result.status = &statuses[at];
  return result;
}

}  // namespace syncline::ui
