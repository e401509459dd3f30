// SPDX-License-Identifier: Apache-2.0
#include "ui/session/running_slaves.h"

#include <algorithm>
#include <map>
#include <utility>

#include "record/run_record.h"
#include "ui/session/live_session.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

bool sameDevice(const Identity& a, const Identity& b) {
  return a.vendor_id == b.vendor_id && a.product_code == b.product_code && a.revision_no == b.revision_no;
}

int elementOf(const std::vector<int>& list, int at) {
  return at >= 0 && static_cast<std::size_t>(at) < list.size() ? list[static_cast<std::size_t>(at)] : -1;
}

}  // namespace

int slaveOf(const Project& project, const NetworkConfig& running, int position) {
  if (position < 0 || static_cast<std::size_t>(position) >= running.slaves.size()) return -1;
  const auto& slave = running.slaves[static_cast<std::size_t>(position)];
  const auto found = std::ranges::find_if(project.slaves, [&](const SlaveSettings& one) {
    return one.station_address == slave.station_address && sameDevice(slave.identity, one.device.identity);
  });
  return found == project.slaves.end() ? -1 : static_cast<int>(found - project.slaves.begin());
}

std::vector<int> positionsIn(const Project& project, const NetworkConfig& running) {
  std::map<std::uint16_t, std::size_t> by_address;
  for (std::size_t i = 0; i < running.slaves.size(); ++i) by_address.emplace(running.slaves[i].station_address, i);
  std::vector<int> positions(project.slaves.size(), -1);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto& slave = project.slaves[i];
    const auto found = by_address.find(slave.station_address);
    if (found == by_address.end()) continue;
    if (sameDevice(running.slaves[found->second].identity, slave.device.identity))
      positions[i] = static_cast<int>(found->second);
  }
  return positions;
}

RunningSlaves::RunningSlaves(const ProjectDocument& document, const LiveSession& live)
    : document_(document), live_(live) {
  connect(&document, &ProjectDocument::taken, this, [this] { stale_ = true; });
  connect(&document, &ProjectDocument::projectChanged, this, [this] { stale_ = true; });
  connect(&live, &LiveSession::recordChanged, this, [this] { stale_ = true; });
}

void RunningSlaves::find() const {
  if (!std::exchange(stale_, false)) return;
  slaves_.clear();
  positions_.assign(document_.project().slaves.size(), -1);
  if (live_.record() == nullptr) return;
  const auto& running = live_.record()->config();
  slaves_.assign(running.slaves.size(), -1);
  positions_ = positionsIn(document_.project(), running);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i] >= 0) slaves_[static_cast<std::size_t>(positions_[i])] = static_cast<int>(i);
  }
}

const std::vector<int>& RunningSlaves::positions() const {
  find();
  return positions_;
}

int RunningSlaves::positionOf(int slave) const { return elementOf(positions(), slave); }

int RunningSlaves::slaveOf(int position) const {
  find();
  return elementOf(slaves_, position);
}

}  // namespace syncline::ui
