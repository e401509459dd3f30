// SPDX-License-Identifier: Apache-2.0
#include "ui/models/cable_counters.h"

#include <algorithm>
#include <utility>

#include "channels/snapshot.h"
#include "config/project.h"
#include "config/wiring_tree.h"
#include "protocol/port_damage.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

std::uint32_t damagedAt(const PortErrors& errors) {
  return damaged_frames(errors.invalid_frames, errors.receive_errors);
}

/// Of the ends of a cable.
struct Tally {
  std::uint32_t count = 0, most = 0;
  bool at_least = false;
  int slave = -1;  // of the most

  void note(std::uint32_t more, bool more_at_least, int at, bool both) {
    if (more == 0) return;
    count = both ? count + more : std::max(count, more);
    at_least = at_least || more_at_least;
    if (more >= most) slave = at;
    most = std::max(most, more);
  }
};

}  // namespace

void CableCounters::setProject(const Project& project) {
  const auto tree = WiringTree::of(project.slaves);
  std::vector<std::optional<Cable>> cables;
  for (std::size_t i = 0; i < tree.slaves().size(); ++i) {
    const auto& slave = tree.slaves()[i];
    auto& cable = cables.emplace_back();
    if (!slave.previous && i > 0) continue;
    cable.emplace().far = {static_cast<int>(i), slave.entry};
    if (slave.previous) cable->near = {slave.previous->position, slave.previous->port};
  }
  if (cables == cables_) return;
  cables_ = std::move(cables);
  reads_.assign(cables_.size(), std::nullopt);
  histories_.clear();
  badges_.assign(cables_.size(), {});
  Q_EMIT changed();
}

/// What a slave counted before it fell silent is not how it stands now.
void CableCounters::read(const Snapshot& snapshot, const std::vector<int>& positions) {
  for (std::size_t i = 0; i < reads_.size(); ++i) {
    const auto at = i < positions.size() ? static_cast<std::size_t>(positions[i]) : snapshot.slaves.size();
    const auto* status = snapshot.online && at < snapshot.slaves.size() ? &snapshot.slaves[at] : nullptr;
    reads_[i].reset();
    if (status == nullptr || !status->present || status->evidence.ports_time == 0) continue;
    reads_[i] = Read{status->evidence.ports, std::max<Nanoseconds>(snapshot.time - status->evidence.ports_time, 0)};
  }
}

/// Whose counters stand at zero needs no memory: they were zero until now.
void CableCounters::follow(Nanoseconds now) {
  for (std::size_t i = 0; i < reads_.size(); ++i) {
    const auto slave = static_cast<int>(i);
    const bool counted = reads_[i] && std::ranges::any_of(reads_[i]->ports, [](const PortErrors& port) {
                           return damagedAt(port) + port.forwarded_errors + port.lost_links > 0;
                         });
    if (!counted) {
      histories_.erase(slave);
      continue;
    }
    const auto [history, begins] = histories_.try_emplace(slave);
    auto totals = portTotals(reads_[i]->ports);
    if (begins && seen_) history->second.add(*seen_, std::vector<std::uint32_t>(totals.size(), 0));
    history->second.add(now, std::move(totals));
  }
}

void CableCounters::setSnapshot(const Snapshot& snapshot, const std::vector<int>& positions) {
  read(snapshot, positions);
  follow(snapshot.time);
  seen_ = snapshot.online ? std::optional(snapshot.time) : std::nullopt;
  const auto damage = first_damaged_port(snapshot.slaves.size(), [&](std::size_t slave, std::size_t port) {
    return damagedAt(snapshot.slaves[slave].evidence.ports[port]) > 0;
  });
  const auto place = std::ranges::find(positions, damage.slave);
  const Plug first{damage.slave < 0 || place == positions.end() ? -1 : static_cast<int>(place - positions.begin()),
                   static_cast<int>(damage.port)};
  std::vector<CableBadge> badges;
  badges.reserve(cables_.size());
  for (const auto& cable : cables_) badges.push_back(cable ? judge(*cable, first) : CableBadge{});
  if (badges == badges_) return;
  badges_ = std::move(badges);
  Q_EMIT changed();
}

const PortErrors* CableCounters::errorsAt(const Plug& plug) const {
  if (plug.slave < 0 || static_cast<std::size_t>(plug.slave) >= reads_.size()) return nullptr;
  const auto& read = reads_[static_cast<std::size_t>(plug.slave)];
  return read ? &read->ports[static_cast<std::size_t>(plug.port) % read->ports.size()] : nullptr;
}

/// Both ends see a link that is lost, and each slave behind it a frame that is forwarded: those are not added up.
CableBadge CableCounters::judge(const Cable& cable, const Plug& first) const {
  Tally damaged, lost, forwarded;
  for (const auto& end : {cable.near, cable.far}) {
    const auto* errors = errorsAt(end);
    if (errors == nullptr) continue;
    damaged.note(damagedAt(*errors), errors->at_least, end.slave, true);
    lost.note(errors->lost_links, errors->at_least, end.slave, false);
    forwarded.note(errors->forwarded_errors, errors->at_least, end.slave, false);
  }
  const auto badge = [](CableDamage damage, const Tally& tally) {
    return CableBadge{damage, tally.count, tally.at_least, tally.slave};
  };
  if (damaged.count > 0) {
    const bool begins = first.slave >= 0 && (first == cable.near || first == cable.far) && errorsAt(first) != nullptr;
    auto result = badge(begins ? CableDamage::kFirst : CableDamage::kHere, damaged);
    if (begins) result.slave = first.slave;
    return result;
  }
  if (lost.count > 0) return badge(CableDamage::kHere, lost);
  if (forwarded.count > 0) return badge(CableDamage::kForwarded, forwarded);
  return {};
}

CableBadge CableCounters::badge(int slave) const {
  return slave >= 0 && static_cast<std::size_t>(slave) < badges_.size() ? badges_[static_cast<std::size_t>(slave)]
                                                                        : CableBadge{};
}

std::vector<CableEnd> CableCounters::ends(int slave) const {
  if (slave < 0 || static_cast<std::size_t>(slave) >= cables_.size()) return {};
  const auto& cable = cables_[static_cast<std::size_t>(slave)];
  if (!cable) return {};
  std::vector<CableEnd> ends;
  for (const auto& plug : {cable->near, cable->far}) {
    auto& end = ends.emplace_back(CableEnd{plug.slave, plug.port, {}});
    const auto* errors = errorsAt(plug);
    if (errors == nullptr) continue;
    auto& reading = end.reading.emplace(
        CableEnd::Reading{.errors = *errors, .age = reads_[static_cast<std::size_t>(plug.slave)]->age, .growth = {}});
    const auto history = histories_.find(plug.slave);
    for (std::size_t i = 0; history != histories_.end() && i < reading.growth.size(); ++i)
      reading.growth[i] = history->second.growth(kCountersOfPort * static_cast<std::size_t>(plug.port) + i);
  }
  return ends;
}

QString badgeText(const CableBadge& badge) {
  const auto text = countText(badge.count);
  return badge.at_least ? QStringLiteral("\u2265") + text : text;
}

}  // namespace syncline::ui
