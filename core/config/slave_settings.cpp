// SPDX-License-Identifier: Apache-2.0
#include "config/slave_settings.h"

#include <algorithm>

#include "config/module_slots.h"
#include "config/slave_edits.h"
#include "config/startup_messages.h"
#include "protocol/station_address.h"

namespace syncline {
namespace {

bool contains(const std::vector<std::uint16_t>& indices, std::uint16_t index) {
  return std::ranges::find(indices, index) != indices.end();
}

bool conflicts(const Pdo& pdo, const std::vector<std::uint16_t>& chosen, const std::vector<Pdo>& pdos) {
  return std::ranges::any_of(chosen, [&](std::uint16_t other) {
    const Pdo* assigned = find_pdo(pdos, other);
    return contains(pdo.exclude, other) || (assigned && contains(assigned->exclude, pdo.index));
  });
}

/// The assignment of one SyncManager becomes `wanted`; what others carry stays.
void assign(SlaveSettings& slave, PdoDirection direction, const OpModeSyncManager& wanted) {
  const auto& pdos = slave.device.pdos(direction);
  const bool all_known =
      std::ranges::all_of(wanted.pdos, [&](std::uint16_t i) { return find_pdo(pdos, i) != nullptr; });
  if (wanted.pdos.empty() || !all_known) return;
  auto& assigned = slave.assigned_pdos(direction);
  std::erase_if(assigned, [&](std::uint16_t index) {
    const Pdo* pdo = find_pdo(pdos, index);
    return contains(wanted.pdos, index) || (pdo && pdo->sync_manager == wanted.number);
  });
  assigned.insert(assigned.end(), wanted.pdos.begin(), wanted.pdos.end());
}

}  // namespace

Pdo effective_pdo(const SlaveSettings& slave, const Pdo& of_device) {
  Pdo pdo = of_device;
  if (const Pdo* changed = find_pdo(slave.changed_pdos, pdo.index)) pdo.entries = changed->entries;
  return pdo;
}

std::vector<std::uint16_t> default_assignment(const DeviceDescription& device, PdoDirection direction) {
  const auto& pdos = device.pdos(direction);
  std::vector<std::uint16_t> chosen;
  for (const bool mandatory : {true, false}) {  // a mandatory PDO wins against one that it excludes
    for (const Pdo& pdo : pdos) {
      const bool wanted = mandatory ? pdo.mandatory : pdo.sync_manager.has_value() && !pdo.mandatory;
      if (wanted && !contains(chosen, pdo.index) && !conflicts(pdo, chosen, pdos)) chosen.push_back(pdo.index);
    }
  }
  std::vector<std::uint16_t> in_esi_order;
  for (const Pdo& pdo : pdos) {
    if (contains(chosen, pdo.index) && !contains(in_esi_order, pdo.index)) in_esi_order.push_back(pdo.index);
  }
  return in_esi_order;
}

void select_op_mode(SlaveSettings& slave, std::string_view name) {
  slave.dc.op_mode = name;
  if (!slave.device.dc) return;
  const auto mode = std::ranges::find(slave.device.dc->op_modes, name, &DcOpMode::name);
  if (mode == slave.device.dc->op_modes.end()) return;
  for (const OpModeSyncManager& manager : mode->sync_managers) {
    assign(slave, PdoDirection::kRx, manager);
    assign(slave, PdoDirection::kTx, manager);
  }
}

SlaveSettings default_slave(const DeviceDescription& device, std::uint16_t position) {
  SlaveSettings slave;
  slave.station_address = usual_station_address(position);
  slave.name = default_name(slave.station_address, device);
  slave.device = device;
  slave.assigned_rx_pdos = default_assignment(device, PdoDirection::kRx);
  slave.assigned_tx_pdos = default_assignment(device, PdoDirection::kTx);
  if (device.dc) {
    slave.dc.potential_reference_clock = device.dc->potential_reference_clock;
    if (!device.dc->op_modes.empty()) select_op_mode(slave, device.dc->op_modes.front().name);
  }
  if (device.mailbox && device.mailbox->coe) slave.startup = device.mailbox->coe->init_commands;
  if (device.mailbox && device.mailbox->soe) slave.soe_startup = device.mailbox->soe_options.init_commands;
  for (const auto& protocol : kMessageProtocols) slave.*protocol.startup = esi_messages(device, protocol.type);
  plug_default_modules(slave);
  return slave;
}

}  // namespace syncline
