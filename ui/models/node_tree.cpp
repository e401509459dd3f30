// SPDX-License-Identifier: Apache-2.0
#include "ui/models/node_tree.h"

#include <algorithm>
#include <utility>

#include "channels/slave_status.h"
#include "channels/snapshot.h"
#include "config/network_config.h"
#include "config/project.h"
#include "config/wiring_tree.h"

namespace syncline::ui {

NodeTree::NodeTree(const Project& project, Shape shape) {
  const auto tree = WiringTree::of(project.slaves);
  slaves_.reserve(project.slaves.size());
  for (const auto& slave : project.slaves) {
    Node node;
    node.name = QString::fromStdString(slave.name);
    node.device = QString::fromStdString(slave.device.type);
    node.group = QString::fromStdString(slave.hot_connect);
    node.optional = slave.optional;
    node.station_address = slave.station_address;
    // A line has one answer for all of its slaves; those before this one have theirs already.
    const auto position = slaves_.size();
    const auto before = tree.previous(position);
    const bool goes_on = before && *before < position && tree.next(*before) == position;
    const auto from = goes_on ? std::nullopt : tree.branches_from(position);
    classic_.push_back(goes_on ? classic_[*before] : from ? static_cast<int>(*from) : -1);
    slaves_.push_back(std::move(node));
  }
  master_.name = QString::fromStdString(project.master.name);
  arrange(shape);
}

int NodeTree::slave_at(int address) const {
  const auto found = std::ranges::find(slaves_, address, [](const Node& node) { return int{node.station_address}; });
  return found == slaves_.end() ? -1 : static_cast<int>(found - slaves_.begin());
}

void NodeTree::arrange(Shape shape) {
  parents_ = shape == Shape::kClassic ? classic_ : std::vector<int>(slaves_.size(), -1);
  rows_.assign(slaves_.size(), 0);
  below_.assign(slaves_.size() + 1, {});
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& siblings = below_[placeOf(parents_[i])];
    rows_[i] = static_cast<int>(siblings.size());
    siblings.push_back(static_cast<int>(i));
  }
}

bool NodeTree::stands_like(const NodeTree& other) const {
  if (parents_ != other.parents_) return false;
  std::size_t others = 0;
  for (std::size_t i = 0; i < slaves_.size(); ++i)
    others += slaves_[i].station_address == other.slaves_[i].station_address ? 0U : 1U;
  return others <= 1;
}

void NodeTree::take_states(const NodeTree& before) {
  master_.al_status = before.master_.al_status;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& node = slaves_[i];
    const auto& old = before.slaves_[i];
    node.al_status = old.al_status;
    node.link = old.link;
    node.live_reference = old.live_reference;
    node.dc = old.dc;
    node.configured_reference = old.configured_reference;
  }
}

NodeTree::Slaves NodeTree::different_from(const NodeTree& other) const {
  Slaves changed;
  for (int slave = -1; slave < size(); ++slave) {
    if (!(node(slave) == other.node(slave))) changed.push_back(slave);
  }
  return changed;
}

NodeTree::Slaves NodeTree::set_configuration(const NetworkConfig* config) {
  Slaves changed;
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    const auto* dc =
        config != nullptr && i < config->slaves.size() && config->slaves[i].dc ? &*config->slaves[i].dc : nullptr;
    const bool leads = dc != nullptr && dc->reference_clock;
    if (slaves_[i].dc == (dc != nullptr) && slaves_[i].configured_reference == leads) continue;
    slaves_[i].dc = dc != nullptr;
    slaves_[i].configured_reference = leads;
    changed.push_back(static_cast<int>(i));
  }
  return changed;
}

NodeTree::Slaves NodeTree::set_snapshot(const Snapshot& snapshot, const std::vector<int>& positions) {
  Slaves changed;
  const int master_state = snapshot.online ? static_cast<int>(snapshot.state) : -1;
  if (std::exchange(master_.al_status, master_state) != master_state) changed.push_back(-1);
  for (std::size_t i = 0; i < slaves_.size(); ++i) {
    auto& node = slaves_[i];
    const auto at = i < positions.size() ? static_cast<std::size_t>(positions[i]) : snapshot.slaves.size();
    const SlaveStatus* status = snapshot.online && at < snapshot.slaves.size() ? &snapshot.slaves[at] : nullptr;
    const int al_status = status == nullptr ? -1 : (status->present ? status->al_status : 0);
    const bool leads = status != nullptr && status->is_reference_clock;
    const auto link = status == nullptr      ? Link::kOffline
                      : status->cable_broken ? Link::kBroken
                      : status->present      ? Link::kGood
                                             : Link::kSilent;
    if (node.al_status == al_status && node.live_reference == leads && node.link == link) continue;
    node.al_status = al_status;
    node.live_reference = leads;
    node.link = link;
    changed.push_back(static_cast<int>(i));
  }
  return changed;
}

}  // namespace syncline::ui
