// SPDX-License-Identifier: Apache-2.0
#include "recover/simulated_network.h"

#include <algorithm>

#include "compile/compile.h"
#include "compile/effective_slave.h"
#include "config/device_description.h"
#include "config/entry_ports.h"
#include "config/project.h"
#include "config/sim_config.h"
#include "families/device_family.h"
#include "families/families.h"
#include "recover/recovered_device.h"
#include "recover/register_writes.h"

namespace syncline {
namespace {

/// Quartzes differ; these do by a fixed rule within +-50 ppm, so that the clocks have something to do.
double ppm_of(std::size_t position) { return static_cast<double>(37 * position % 101) - 50.0; }

bool is_known(const DeviceDescription& device, std::uint16_t index) {
  if (index >= 0x1C00 && index <= 0x1C2F) return true;  // the simulated device has SyncManager objects of its own
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    if (std::ranges::count(device.pdos(direction), index, &Pdo::index) > 0) return true;
  }
  return false;
}

ObjectEntry& entry_of(DeviceDescription& device, std::uint16_t index, std::uint8_t sub_index) {
  auto object = std::ranges::find(device.dictionary, index, &ObjectDescription::index);
  if (object == device.dictionary.end()) {
    device.dictionary.push_back({.index = index, .name = "Object of the start-up list", .entries = {}});
    object = device.dictionary.end() - 1;
  }
  auto entry = std::ranges::find(object->entries, sub_index, &ObjectEntry::sub_index);
  if (entry == object->entries.end()) {
    const auto place = std::ranges::upper_bound(object->entries, sub_index, {}, &ObjectEntry::sub_index);
    entry = object->entries.insert(place, ObjectEntry{});
    entry->sub_index = sub_index;
    entry->writable = true;
  }
  return *entry;
}

void add_entry(DeviceDescription& device, std::uint16_t index, std::uint8_t sub_index, std::size_t bytes) {
  auto& entry = entry_of(device, index, sub_index);
  entry.bit_length = std::max(entry.bit_length, static_cast<std::uint16_t>(8 * std::min<std::size_t>(bytes, 8000)));
}

/// Complete access: the count in 16 bits, then entries that are taken to be of one size.
void add_complete(DeviceDescription& device, const StartupCommand& command) {
  const std::size_t count = command.data.empty() ? 0 : command.data[0];
  const std::size_t rest = command.data.size() < 2 ? 0 : command.data.size() - 2;
  add_entry(device, command.index, 0, 1);
  const bool even = count > 0 && rest % count == 0;
  for (std::size_t sub = 1; sub <= (even ? count : 1); ++sub) {
    add_entry(device, command.index, static_cast<std::uint8_t>(sub), even ? rest / count : rest);
  }
}

/// An entry that a PDO maps has the size that the PDO says.
bool is_mapped(const DeviceDescription& device, const StartupCommand& command) {
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const auto& pdo : device.pdos(direction)) {
      for (const auto& entry : pdo.entries) {
        if (entry.index == command.index && entry.sub_index == command.sub_index) return true;
      }
    }
  }
  return false;
}

bool is_described(const DeviceDescription& device, std::uint16_t index) {
  return std::ranges::count(device.dictionary, index, &ObjectDescription::index) > 0;
}

/// The objects that the start-up commands write, where the device does not describe them itself.
void make_objects(DeviceDescription& device, const MailboxConfig& mailbox) {
  const DeviceDescription described = device;
  for (const auto& [command, ccs] : mailbox.coe_commands) {
    if (!command.enabled || is_known(device, command.index) || is_described(described, command.index)) continue;
    if (command.complete_access && command.sub_index == 0) {
      add_complete(device, command);
    } else if (!is_mapped(device, command)) {
      add_entry(device, command.index, command.sub_index, command.data.size());
    }
  }
}

std::uint8_t at_least(std::uint8_t usual, std::size_t needed) {
  return static_cast<std::uint8_t>(std::max<std::size_t>(usual, std::min<std::size_t>(needed, 16)));
}

/// As the slaves say where they hang; one that does not say it, or says what cannot be, at the one before it.
void wire(SimConfig& config, std::span<const std::optional<PreviousPort>> previous) {
  const auto entries = entry_ports(previous);
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    auto& slave = config.slaves[i];
    slave.oscillator.ppm = ppm_of(i);
    slave.entry_port = entries[i].value_or(0);
    const bool said = previous[i] && previous[i]->position < previous.size() &&
                      (previous[i]->position < i || entries[previous[i]->position]);
    if (said) {
      slave.parent = previous[i]->position;
      slave.parent_port = previous[i]->port;
    } else if (i > 0 && config.slaves[0].parent) {
      continue;  // the one that is wired to the master, behind some that hang at it
    } else if (i > 0) {
      slave.parent = static_cast<std::uint16_t>(i - 1);
    }
  }
}

SimSlaveConfig simulated_slave(const SlaveConfig& slave, Nanoseconds cycle) {
  SimSlaveConfig simulated;
  simulated.name = slave.name;
  simulated.device = recover::recovered_device(slave, cycle);
  simulated.behaviour = families::behaviour_of(simulated.device);
  simulated.alias = slave.alias;
  if (slave.hot_connect && slave.hot_connect->alias()) simulated.alias = *slave.hot_connect->alias();
  if (slave.identification) simulated.device_id = static_cast<std::uint16_t>(slave.identification->value);
  simulated.serial_no = slave.identity.serial_no;
  if (slave.mailbox) make_objects(simulated.device, *slave.mailbox);
  const auto writes = recover::register_writes(slave.init_cmds);
  if (!writes.fmmus.empty()) {
    simulated.fmmu_count = at_least(simulated.fmmu_count, writes.fmmus.rbegin()->first + 1U);
  }
  simulated.sync_manager_count = at_least(simulated.sync_manager_count, simulated.device.sync_managers.size());
  return simulated;
}

/// Frame order is the order of the wiring; where the ENI's ports say another one, a line is as good as any.
void straighten(SimConfig& config) {
  std::vector<std::uint32_t> taken(config.slaves.size());
  for (std::size_t i = 0; i < config.slaves.size(); ++i) taken[i] = 1U << config.slaves[i].entry_port;
  std::size_t roots = 0;
  bool consistent = true;
  for (const auto& slave : config.slaves) {
    if (!slave.parent) {
      ++roots;
      continue;
    }
    auto& ports = taken[*slave.parent];
    const auto port = 1U << slave.parent_port;
    // A port has one cable.
    consistent = consistent && slave.parent_port <= 3 && (ports & port) == 0;
    ports |= port;
  }
  if (consistent && roots == 1) return;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    auto& slave = config.slaves[i];
    slave.parent = i > 0 ? std::optional(static_cast<std::uint16_t>(i - 1)) : std::nullopt;
    slave.parent_port = 1;
    slave.entry_port = 0;
  }
}

}  // namespace

SimConfig simulated_network(const NetworkConfig& config) {
  SimConfig simulated;
  simulated.name = config.master.name;
  std::vector<std::optional<PreviousPort>> previous;
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    simulated.slaves.push_back(simulated_slave(config.slaves[i], config.cycle_time()));
    previous.push_back(config.slaves[i].previous);
  }
  wire(simulated, previous);
  straighten(simulated);
  return simulated;
}

SimConfig simulated_network(const Project& project) {
  SimConfig simulated;
  simulated.name = project.master.name;
  const auto compiled = compile(project);
  std::vector<std::optional<PreviousPort>> previous;
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    const auto effective = compiler::effective_slave(project.slaves[i]);
    const SlaveSettings& slave = effective ? *effective : project.slaves[i];
    SimSlaveConfig& added = simulated.slaves.emplace_back();
    added.name = slave.name;
    added.behaviour = families::behaviour_of(slave.device);
    added.device = slave.device;
    added.alias = slave.alias;
    added.device_id = slave.check.device_id.value_or(0);
    added.serial_no = slave.device.identity.serial_no;
    added.sync_manager_count = at_least(added.sync_manager_count, slave.device.sync_managers.size());
    added.fmmu_count = at_least(added.fmmu_count, slave.device.fmmus.size());
    if (compiled && compiled->config.slaves[i].mailbox) make_objects(added.device, *compiled->config.slaves[i].mailbox);
    previous.push_back(slave.previous);
  }
  wire(simulated, previous);
  straighten(simulated);
  return simulated;
}

}  // namespace syncline
