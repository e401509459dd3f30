// SPDX-License-Identifier: Apache-2.0
#include "ui/session/running_slave.h"

#include <algorithm>

#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

bool sameDevice(const Identity& a, const Identity& b) {
  return a.vendor_id == b.vendor_id && a.product_code == b.product_code && a.revision_no == b.revision_no;
}

}  // namespace

AlState RunningSlave::state() const { return present() ? al_state_of(status->al_status) : AlState::kNone; }

std::optional<RunningSlave> runningSlave(Workspace& workspace, int slave) {
  const auto& live = workspace.live();
  const auto& slaves = workspace.document().project().slaves;
  const auto at = static_cast<std::size_t>(slave);
  if (slave < 0 || at >= slaves.size() || live.requests() == nullptr || live.record() == nullptr) return std::nullopt;
  const auto& running = live.record()->config().slaves;
  const auto found = std::ranges::find_if(running, [&](const SlaveConfig& one) {
    return one.station_address == slaves[at].station_address && sameDevice(one.identity, slaves[at].device.identity);
  });
  if (found == running.end()) return std::nullopt;
  RunningSlave result;
  result.position = static_cast<std::uint16_t>(found - running.begin());
  result.config = &*found;
  const auto& statuses = live.snapshot().slaves;
  if (result.position < statuses.size()) result.status = &statuses[result.position];
  return result;
}

}  // namespace syncline::ui
