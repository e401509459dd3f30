// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/startup_messages.h"
#include "ui_test_support.h"

namespace syncline::test {

/// A machine in which every field of every page can be edited.
inline Project editableProject() {
  auto project = smallProject();
  project.master.dc.sync_window.enabled = true;
  for (std::size_t i = 1; i < project.slaves.size(); ++i) {
    auto& slave = project.slaves[i];
    slave.device.mailbox.emplace().coe.emplace();
    auto& modes = slave.device.dc->op_modes;
    modes.front().assign_activate = 0x0700;
    modes.push_back(modes.front());
    modes.back().name = "DC 2";
    slave.device.tx_pdos = {slave.device.rx_pdos[2]};
    slave.device.tx_pdos.front().index = 0x1A00;
    slave.dc.sync0.user_cycle = slave.dc.sync1.user_cycle = kMillisecond;
  }
  auto& drive = project.slaves[1].device;
  drive.mailbox->eoe = drive.mailbox->aoe = true;
  drive.rx_pdos.front().os_max = 4;
  ModuleDescription module;
  module.ident = 0x10;
  module.type = "Axis";
  SlotDescription slot;
  slot.name = "Axes";
  slot.max_instances = 2;
  slot.modules = {{.ident = module.ident}};
  drive.slots.emplace();
  drive.slots->slots = {slot};
  drive.modules = {module};
  project.master.sync_units = {{"Infeed", {}}, {"Heating", {}}};
  project.master.tasks = {{"Slow", 4}};
  auto& with_lists = project.slaves[1];
  with_lists.device.mailbox->soe = true;
  with_lists.device.mailbox->coe->pdo_config = true;
  StartupCommand command;
  command.transitions = {Transition::kPS};
  command.index = 0x6060;
  command.data = {8};
  with_lists.startup = {command, command};
  SoeCommand parameter;
  parameter.transitions = {Transition::kPS};
  parameter.idn = 47;
  parameter.data = {1, 0};
  with_lists.soe_startup = {parameter};
  with_lists.device.mailbox->foe = with_lists.device.mailbox->voe = true;
  for (const auto& protocol : kMessageProtocols) {
    MailboxInitCmd message;
    message.transitions = {Transition::kPS};
    message.data = {1, 0, 0, 0};
    with_lists.*protocol.startup = {message};
  }
  RegisterCommand own;
  own.address = 0x0F10;
  own.read = true;
  own.data = {0, 0};
  own.expected = {1, 0};
  own.mask = {0xFF, 0xFF};
  with_lists.register_commands = project.master.register_commands = {own};
  return project;
}

/// With devices of which more is known than their ESI says: a CAN gateway, a drive with output pins.
inline Project projectOfFamilies() {
  auto project = editableProject();
  for (const auto& identity : {Identity{2, 0x1A5F3052, 0x00120000, 0}, Identity{0xAB, 0x1030, 0, 0}}) {
    auto& slave = project.slaves.emplace_back(project.slaves[2]);
    slave.device.identity = identity;
    slave.station_address = static_cast<std::uint16_t>(1000 + project.slaves.size());
    slave.name = "Slave_" + std::to_string(slave.station_address);
  }
  return project;
}

}  // namespace syncline::test
