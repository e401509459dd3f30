// SPDX-License-Identifier: Apache-2.0
#include "compare/replaced_slave.h"

#include <algorithm>

#include "config/wiring_tree.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

Project alone(const SlaveSettings& slave) {
  Project project;
  project.slaves = {slave};
  project.slaves.front().previous.reset();
  return project;
}

std::vector<settings::Place> carried_places(const settings::Setting& setting, const Project& project) {
  return setting.items ? setting.items(project, 0) : std::vector<settings::Place>{settings::Place{}};
}

bool is_same_product(const Identity& left, const Identity& right) {
  return left.vendor_id == right.vendor_id && left.product_code == right.product_code;
}

/// What does not let the device stand where the slave does.
std::optional<WiringObstacle> obstacle_of(const Project& project, std::size_t slave, const DeviceDescription& device) {
  if (slave >= project.slaves.size()) return WiringObstacle::kNoSuchSlave;
  const auto tree = WiringTree::of(project.slaves);
  const auto& wired = tree.slaves()[slave];
  if (wired.previous) {
    const auto kind = port_kind(*tree.slaves()[wired.previous->position].device, wired.previous->port);
    // What the user wired by hand may already be otherwise than the devices say.
    const bool fitted = ports_fit(kind, tree.entry_kind(slave));
    if (fitted && !ports_fit(kind, port_kind(device, wired.entry))) return WiringObstacle::kOtherKind;
  }
  for (const auto behind : tree.behind(slave)) {
    const auto port = tree.slaves()[behind].previous->port;
    const auto kind = tree.entry_kind(behind);
    const bool fitted = ports_fit(port_kind(*wired.device, port), kind);
    if (fitted && !ports_fit(port_kind(device, port), kind)) return WiringObstacle::kNoPort;
  }
  return std::nullopt;
}

}  // namespace

ReplacedSlave replaced_slave(const SlaveSettings& old, const SlaveSettings& fresh, Carry carry) {
  const auto from = alone(old);
  auto to = alone(fresh);
  const auto untouched = alone(default_slave(old.device, 0));
  std::vector<const settings::Setting*> lost;
  for (const auto& setting : settings::table()) {
    if (!setting.of_slave() || setting.key == "slave.N.previous") continue;
    const auto by_default = carried_places(setting, untouched);
    for (const auto& place : carried_places(setting, from)) {
      const auto value = setting.read(from, place);
      const bool known = std::ranges::find(by_default, place) != by_default.end();
      if (carry == Carry::kChanged && known && setting.read(untouched, place) == value) continue;
      if (setting.read(to, place) == value || settings::set_value(setting, to, place, value)) continue;
      if (std::ranges::find(lost, &setting) == lost.end()) lost.push_back(&setting);
    }
  }
  return {std::move(to.slaves.front()), std::move(lost)};
}

Expected<ReplacedDevice, WiringObstacle> replace_device(const Project& project, std::size_t slave,
                                                        const DeviceDescription& device) {
  if (const auto obstacle = obstacle_of(project, slave, device)) return tl::unexpected(*obstacle);
  const auto& old = project.slaves[slave];
  const auto carry = is_same_product(old.device.identity, device.identity) ? Carry::kAll : Carry::kChanged;
  auto replaced = replaced_slave(old, default_slave(device, static_cast<std::uint16_t>(slave)), carry);
  auto& now = replaced.slave;
  now.station_address = old.station_address;
  now.previous = old.previous;
  const bool own_name = old.name != default_name(old.station_address, old.device);
  now.name = own_name ? old.name : default_name(now.station_address, device);
  ReplacedDevice out{project, {}};
  out.project.slaves[slave] = std::move(now);
  for (const auto* setting : replaced.lost) out.lost.push_back(settings::key_of(*setting, {.slave = slave}));
  return out;
}

}  // namespace syncline
