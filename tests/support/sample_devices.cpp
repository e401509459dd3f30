// SPDX-License-Identifier: Apache-2.0
#include "tests/support/sample_devices.h"

#include <algorithm>

namespace syncline::sample {

Pdo pdo(std::uint16_t index, std::string name, std::optional<std::uint8_t> manager, std::vector<PdoEntry> entries) {
  Pdo out;
  out.index = index;
  out.name = std::move(name);
  out.sync_manager = manager;
  out.fixed = true;
  out.entries = std::move(entries);
  return out;
}

SyncManagerDescription manager(SyncManagerType type, std::uint16_t start, std::uint8_t control) {
  SyncManagerDescription out;
  out.type = type;
  out.start_address = start;
  out.control_byte = control;
  out.enable = true;
  return out;
}

DeviceDescription coupler() {
  DeviceDescription device;
  device.identity = {0x5EC, 0x1100, 0x10000, 0};
  device.type = "SC1100";
  device.physics = "YKY";
  device.eeprom.config_data = {0x01, 0x01};
  return device;
}

DeviceDescription digital_input() {
  DeviceDescription device;
  device.identity = {0x5EC, 0x1002, 0x10000, 0};
  device.type = "SI1002";
  device.physics = "KK";
  device.eeprom.config_data = {0x04, 0x01};
  device.fmmus = {FmmuUse::kInputs};
  device.sync_managers = {manager(SyncManagerType::kInputs, 0x1000, 0x00)};
  device.tx_pdos = {pdo(0x1A00, "Channel 1", 0, {{0x6000, 1, 1, "Input", "BOOL"}}),
                    pdo(0x1A01, "Channel 2", 0, {{0x6010, 1, 1, "Input", "BOOL"}})};
  return device;
}

DeviceDescription digital_output() {
  DeviceDescription device;
  device.identity = {0x5EC, 0x2002, 0x10000, 0};
  device.type = "SO2002";
  device.physics = "KK";
  device.eeprom.config_data = {0x04, 0x01};
  device.fmmus = {FmmuUse::kOutputs};
  device.sync_managers = {manager(SyncManagerType::kOutputs, 0x0F00, 0x44)};
  device.sync_managers[0].op_only = true;
  device.rx_pdos = {pdo(0x1600, "Channel 1", 0, {{0x7000, 1, 1, "Output", "BOOL"}}),
                    pdo(0x1601, "Channel 2", 0, {{0x7010, 1, 1, "Output", "BOOL"}})};
  return device;
}

DcOpMode op_mode(std::string name, std::uint16_t assign_activate, int sync0_factor) {
  DcOpMode mode;
  mode.name = std::move(name);
  mode.assign_activate = assign_activate;
  mode.cycle_time_sync0.factor = sync0_factor;
  return mode;
}

DeviceDescription servo() {
  DeviceDescription device;
  device.identity = {0x5EC, 0x402, 0x10002, 0};
  device.type = "SV402";
  device.physics = "YY";
  device.eeprom.config_data = {0x05, 0x0C};
  device.eeprom.boot_strap = {0x00, 0x10, 0x00, 0x02, 0x00, 0x12, 0x00, 0x02};
  device.fmmus = {FmmuUse::kOutputs, FmmuUse::kInputs};
  device.sync_managers = {
      manager(SyncManagerType::kMailboxOut, 0x1000, 0x26), manager(SyncManagerType::kMailboxIn, 0x1080, 0x22),
      manager(SyncManagerType::kOutputs, 0x1100, 0x64), manager(SyncManagerType::kInputs, 0x1180, 0x20)};
  device.sync_managers[0].default_size = device.sync_managers[1].default_size = 128;
  device.sync_managers[2].max_size = device.sync_managers[3].max_size = 32;
  device.rx_pdos = {
      pdo(0x1600, "Outputs", 2, {{0x6040, 0, 16, "Control word", "UINT"}, {0x607A, 0, 32, "Target position", "DINT"}}),
      pdo(0x1601, "User outputs", std::nullopt, {{0x60FF, 0, 32, "Target velocity", "DINT"}})};
  device.rx_pdos[1].fixed = false;
  device.tx_pdos = {pdo(
      0x1A00, "Inputs", 3,
      {{0x6041, 0, 16, "Status word", "UINT"}, {0, 0, 16, "", ""}, {0x6064, 0, 32, "Position actual value", "DINT"}})};
  device.mailbox.emplace();
  device.mailbox->foe = true;
  device.mailbox->coe.emplace();
  device.mailbox->coe->sdo_info = device.mailbox->coe->pdo_assign = device.mailbox->coe->pdo_config = true;
  StartupCommand interpolation;
  interpolation.index = 0x60C2;
  interpolation.sub_index = 1;
  interpolation.data = {2};
  interpolation.comment = "Cycle time";
  device.mailbox->coe->init_commands = {interpolation};
  device.dc.emplace();
  device.dc->op_modes = {op_mode("DC Sync", 0x0300, 1), op_mode("Off", 0x0000, 0)};
  device.reg_0400 = 0x09C2;
  device.reg_0420 = 1000;
  device.profiles = {{402, 2}};
  return device;
}

SlaveSettings slave(DeviceDescription device, std::uint16_t position) {
  SlaveSettings out;
  out.station_address = static_cast<std::uint16_t>(1001 + position);
  out.name = "Slave_" + std::to_string(out.station_address) + " [" + device.type + "]";
  if (position > 0) {
    out.previous = PreviousPort{static_cast<std::uint16_t>(position - 1), 1};
  }
  for (const auto& p : device.rx_pdos) {
    if (p.sync_manager) out.assigned_rx_pdos.push_back(p.index);
  }
  for (const auto& p : device.tx_pdos) {
    if (p.sync_manager) out.assigned_tx_pdos.push_back(p.index);
  }
  if (device.dc) out.dc.op_mode = device.dc->op_modes.front().name;
  if (device.mailbox && device.mailbox->coe) out.startup = device.mailbox->coe->init_commands;
  out.device = std::move(device);
  return out;
}

Project project(std::vector<DeviceDescription> devices) {
  Project out;
  for (auto& device : devices) {
    out.slaves.push_back(slave(std::move(device), static_cast<std::uint16_t>(out.slaves.size())));
  }
  return out;
}

Project small_machine() { return project({coupler(), digital_input(), digital_output(), servo()}); }

}  // namespace syncline::sample
