// SPDX-License-Identifier: Apache-2.0
#include "config/slave_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "config/device_description.h"
#include "config/project.h"
#include "config/wiring_draft.h"
#include "config/wiring_tree.h"
#include "protocol/station_address.h"

namespace syncline {
namespace {

constexpr std::size_t kMostSlaves = 65'535;

using Obstacle = WiringObstacle;
tl::unexpected<Obstacle> no(Obstacle obstacle) { return tl::unexpected(obstacle); }

std::set<std::string> names_of(const Project& project) {
  std::set<std::string> names;
  for (const auto& slave : project.slaves) names.insert(slave.name);
  return names;
}

std::set<std::uint16_t> addresses_of(const Project& project) {
  std::set<std::uint16_t> used;
  for (const auto& slave : project.slaves) used.insert(slave.station_address);
  return used;
}

SlaveSettings new_slave(const Project& project, const DeviceDescription& device) {
  auto slave = default_slave(device, static_cast<std::uint16_t>(project.slaves.size()));
  auto used = addresses_of(project);
  slave.station_address = take_address(used, slave.station_address);
  auto names = names_of(project);
  slave.name = take_name(names, default_name(slave.station_address, device));
  return slave;
}

/// The project as the draft wires it, with new slaves behind those that it had.
std::size_t apply(Project& project, const WiringDraft& draft, std::vector<SlaveSettings> added, std::size_t follow) {
  const auto order = draft.order();  // first: it looks at the devices where they are
  auto all = std::move(project.slaves);
  std::ranges::move(added, std::back_inserter(all));
  std::vector<std::optional<std::uint16_t>> place(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<std::uint16_t>(i);
  project.slaves.clear();
  for (const auto id : order) {
    auto& slave = project.slaves.emplace_back(std::move(all[id]));
    slave.previous = draft.slaves()[id].previous;
    if (slave.previous) slave.previous->position = *place[slave.previous->position];
  }
  auto& reference = project.master.dc.reference_clock;
  if (reference && *reference < place.size()) reference = place[*reference];
  return place[follow].value_or(0);
}

EditedSlave add(Project& project, const DeviceDescription& device, std::optional<PreviousPort> at) {
  WiringDraft draft(project.slaves);
  std::vector<SlaveSettings> added{new_slave(project, device)};
  const auto id = draft.add(added.front().device, 0, project.slaves.size());
  if (const auto obstacle = at ? draft.attach(id, *at) : draft.attach_first(id)) return no(*obstacle);
  return apply(project, draft, std::move(added), id);
}

/// Where the place of `target` does not take a slave, the line may that ends just before it: then `put` puts it behind
/// the last one there. Else `obstacle`.
template <class Put>
EditedSlave at_the_end_before(Project& project, std::size_t target, Obstacle obstacle, Put&& put) {
  if (target == 0) return no(obstacle);
  const auto address = project.slaves[target].station_address;
  auto tried = project;
  const auto placed = put(tried, target - 1);
  if (!placed) return no(obstacle);
  const auto behind = WiringTree::of(tried.slaves).group(*placed).back() + 1;
  if (behind >= tried.slaves.size() || tried.slaves[behind].station_address != address) return no(obstacle);
  project = std::move(tried);
  return placed;
}

}  // namespace

EditedSlave add_slave(Project& project, const DeviceDescription& device, std::optional<std::size_t> behind) {
  if (project.slaves.size() >= kMostSlaves) return no(Obstacle::kTooMany);
  if (project.slaves.empty()) return add(project, device, {});
  const auto target = behind.value_or(project.slaves.size() - 1);
  if (target >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  const auto id = draft.add(device, 0, target + 1);
  const auto at = draft.place_behind(target, id);
  return at ? add(project, device, at) : EditedSlave(no(Obstacle::kNoPort));
}

EditedSlave add_slave_before(Project& project, const DeviceDescription& device, std::size_t target) {
  if (project.slaves.size() >= kMostSlaves) return no(Obstacle::kTooMany);
  if (target >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  std::vector<SlaveSettings> added{new_slave(project, device)};
  const auto id = draft.add(added.front().device, 0, target);
  if (const auto obstacle = draft.attach_before(id, target))
    return at_the_end_before(project, target, *obstacle,
                             [&](Project& tried, std::size_t last) { return add_slave(tried, device, last); });
  return apply(project, draft, std::move(added), id);
}

EditedSlave add_slave_at(Project& project, const DeviceDescription& device, PreviousPort at) {
  if (project.slaves.size() >= kMostSlaves) return no(Obstacle::kTooMany);
  if (const auto obstacle = plug_obstacle(WiringTree::of(project.slaves), device, at)) return no(*obstacle);
  return add(project, device, at);
}

EditedSlave remove_slave(Project& project, std::size_t slave) {
  if (slave >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  const auto tree = draft.tree();
  const auto group = tree.group(slave);
  const auto next = tree.next(slave);
  const auto before = tree.previous(slave);
  draft.detach(slave);
  draft.drop(group);
  return apply(project, draft, {}, next ? *next : before.value_or(slave));
}

EditedSlave duplicate_slave(Project& project, std::size_t slave) {
  if (slave >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  const auto group = draft.tree().group(slave);
  const auto count = project.slaves.size();
  if (count + group.size() > kMostSlaves) return no(Obstacle::kTooMany);
  std::vector<SlaveSettings> added;
  auto used = addresses_of(project);
  auto names = names_of(project);
  for (const auto one : group) {
    auto copy = project.slaves[one];
    const bool had_default = copy.name == default_name(copy.station_address, copy.device);
    copy.station_address = take_address(used, usual_station_address(count + added.size()));
    copy.name = take_name(names, had_default ? default_name(copy.station_address, copy.device) : copy.name);
    copy.alias = 0;
    if (!copy.hot_connect.empty()) copy.hot_connect = copy.name;
    added.push_back(std::move(copy));
  }
  const auto at = draft.place_of_copy(slave);
  if (!at) return no(Obstacle::kNoPort);
  const auto first = draft.add_copies(group, group.back() + 1);
  if (const auto obstacle = draft.attach(first, *at)) return no(*obstacle);
  return apply(project, draft, std::move(added), first);
}

EditedSlave move_slave_behind(Project& project, std::size_t slave, std::size_t target) {
  if (std::max(slave, target) >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  if (std::ranges::binary_search(draft.tree().group(slave), target)) return no(Obstacle::kBehindIt);
  draft.detach(slave);
  const auto at = draft.place_behind(target, slave);
  if (!at) return no(Obstacle::kNoPort);
  if (const auto obstacle = draft.attach(slave, *at)) return no(*obstacle);
  return apply(project, draft, {}, slave);
}

EditedSlave move_slave_first(Project& project, std::size_t slave) {
  if (slave >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  draft.detach(slave);
  if (const auto obstacle = draft.attach_first(slave)) return no(*obstacle);
  return apply(project, draft, {}, slave);
}

EditedSlave move_slave_before(Project& project, std::size_t slave, std::size_t target) {
  if (std::max(slave, target) >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  if (slave == target) return slave;
  WiringDraft draft(project.slaves);
  if (std::ranges::binary_search(draft.tree().group(slave), target)) return no(Obstacle::kBehindIt);
  draft.detach(slave);
  if (const auto obstacle = draft.attach_before(slave, target))
    return at_the_end_before(project, target, *obstacle, [slave](Project& tried, std::size_t last) {
      return last == slave ? EditedSlave(slave) : move_slave_behind(tried, slave, last);
    });
  return apply(project, draft, {}, slave);
}

EditedSlave move_slave_up(Project& project, std::size_t slave) {
  if (slave >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  WiringDraft draft(project.slaves);
  const auto tree = draft.tree();
  const auto before = tree.previous(slave);
  if (!before || tree.next(*before) != slave) return no(Obstacle::kFirst);
  draft.detach(slave);
  if (const auto obstacle = draft.attach_before(slave, *before)) return no(*obstacle);
  return apply(project, draft, {}, slave);
}

EditedSlave move_slave_down(Project& project, std::size_t slave) {
  if (slave >= project.slaves.size()) return no(Obstacle::kNoSuchSlave);
  const auto next = WiringTree::of(project.slaves).next(slave);
  if (!next) return no(Obstacle::kLast);
  const auto address = project.slaves[slave].station_address;
  if (auto moved = move_slave_up(project, *next); !moved) return moved;
  const auto found = std::ranges::find(project.slaves, address, &SlaveSettings::station_address);
  return static_cast<std::size_t>(found - project.slaves.begin());
}

EditedSlave rewire_slave(Project& project, std::size_t slave, PreviousPort at) {
  WiringDraft draft(project.slaves);
  if (const auto obstacle = rewire_obstacle(draft.tree(), slave, at)) return no(*obstacle);
  draft.hang(slave, at);
  return apply(project, draft, {}, slave);
}

std::optional<WiringObstacle> rewire_obstacle(const WiringTree& tree, std::size_t slave, PreviousPort at) {
  if (slave >= tree.slaves().size() || at.position >= tree.slaves().size()) return Obstacle::kNoSuchSlave;
  for (std::optional<std::size_t> up = at.position; up; up = tree.previous(*up)) {
    if (*up == slave) return Obstacle::kBehindIt;
  }
  if (tree.slaves()[slave].previous == at) return std::nullopt;
  if (!tree.is_free(at.position, at.port)) return Obstacle::kPortTaken;
  const auto kind = port_kind(*tree.slaves()[at.position].device, at.port);
  return ports_fit(kind, tree.entry_kind(slave)) ? std::nullopt : std::optional(Obstacle::kOtherKind);
}

std::optional<WiringObstacle> plug_obstacle(const WiringTree& tree, const DeviceDescription& device, PreviousPort at) {
  if (at.position >= tree.slaves().size()) return Obstacle::kNoSuchSlave;
  if (!tree.is_free(at.position, at.port)) return Obstacle::kPortTaken;
  const auto kind = port_kind(*tree.slaves()[at.position].device, at.port);
  return ports_fit(kind, port_kind(device, 0)) ? std::nullopt : std::optional(Obstacle::kOtherKind);
}

std::uint16_t take_address(std::set<std::uint16_t>& used, std::uint16_t wanted) {
  while (wanted == 0 || !used.insert(wanted).second) ++wanted;
  return wanted;
}

std::string take_name(std::set<std::string>& names, const std::string& wanted) {
  auto name = wanted;
  for (int number = 2; !names.insert(name).second; ++number) name = fmt::format("{} ({})", wanted, number);
  return name;
}

std::string default_name(std::uint16_t station_address, const DeviceDescription& device) {
  return fmt::format("Slave_{} [{}]", station_address, device.type);
}

}  // namespace syncline
