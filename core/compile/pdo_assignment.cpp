// SPDX-License-Identifier: Apache-2.0
#include "compile/pdo_assignment.h"

#include <algorithm>

#include "compile/slave_plan.h"
#include "config/pdo_sync_manager.h"
#include "config/slave_config.h"
#include "config/slave_settings.h"

namespace syncline::compiler {
namespace {

void append(std::vector<ConfiguredPdo>& out, const SlaveSettings& slave, PdoDirection direction) {
  const auto& chosen = slave.assigned_pdos(direction);
  for (const Pdo& of_device : slave.device.pdos(direction)) {
    Pdo pdo = effective_pdo(slave, of_device);
    const bool is_assigned = std::ranges::find(chosen, pdo.index) != chosen.end();
    pdo.sync_manager = is_assigned ? sync_manager_of(slave, direction, of_device) : std::nullopt;
    out.push_back({direction, std::move(pdo)});
  }
}

}  // namespace

std::vector<ConfiguredPdo> effective_pdos(const SlaveSettings& slave) {
  std::vector<ConfiguredPdo> out;
  append(out, slave, PdoDirection::kTx);
  append(out, slave, PdoDirection::kRx);
  return out;
}

std::vector<ProcessDataChannel> process_data_channels(const SlaveSettings& slave) {
  std::vector<ProcessDataChannel> channels;
  const auto& managers = slave.device.sync_managers;
  for (std::size_t n = 0; n < managers.size(); ++n) {
    const bool process_data =
        managers[n].type == SyncManagerType::kOutputs || managers[n].type == SyncManagerType::kInputs;
    if (process_data) {
      channels.push_back({static_cast<std::uint8_t>(n), managers[n], {}, 0});
    }
  }
  for (const auto direction : {PdoDirection::kRx, PdoDirection::kTx}) {
    for (const std::uint16_t index : slave.assigned_pdos(direction)) {
      const Pdo* of_device = find_pdo(slave.device.pdos(direction), index);
      const auto number = of_device ? sync_manager_of(slave, direction, *of_device) : std::nullopt;
      const auto channel = std::ranges::find_if(channels, [&](const auto& c) { return number && c.number == *number; });
      if (channel != channels.end() && std::ranges::find(channel->pdos, index) == channel->pdos.end()) {
        channel->pdos.push_back(index);
        channel->bit_length += effective_pdo(slave, *of_device).bit_length();
      }
    }
  }
  std::erase_if(channels, [](const auto& c) { return c.description.is_virtual && c.bit_length == 0; });
  for (auto& channel : channels) {
    channel.description.enable = channel.bit_length > 0 && !channel.description.is_virtual;
  }
  return channels;
}

bool is_bit_oriented(const SlaveSettings& slave) {
  if (slave.device.mailbox) {
    return false;
  }
  bool any = false;
  for (const auto& [direction, pdo] : effective_pdos(slave)) {
    if (!pdo.sync_manager) {
      continue;
    }
    for (const PdoEntry& entry : pdo.entries) {
      any = true;
      if (entry.bit_length >= 8) {
        return false;
      }
    }
  }
  return any;
}

}  // namespace syncline::compiler
