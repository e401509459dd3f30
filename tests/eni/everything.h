// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "compile/compile.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {

inline MailboxInitCmd message(std::vector<std::uint8_t> data, std::string comment) {
  return {{Transition::kIP, Transition::kPS}, std::move(data), 250, true, true, std::move(comment)};
}

inline void fill_master(MasterConfig& master) {
  master.eoe = true;
  master.eoe_settings = {3, 60, 12};
  master.mailbox_state_count = 2;
  master.mailbox_state_start = 0x0A00'0000;
  InitCmd check;
  check.transitions = {Transition::kIP};
  check.before_slave = true;
  check.requires_frame = true;
  check.comment = "at least two slaves";
  check.command = Command::kBrd;
  check.ado = 0x0130;
  check.data = {0, 0};
  check.validate = InitCmdValidate{{2, 0}, {0xFF, 0x0F}, 100, ValidateType::kGreaterOrEqual, true};
  master.init_cmds.push_back(check);
}

inline void fill_mailbox(MailboxConfig& mailbox) {
  mailbox.aoe = mailbox.eoe = mailbox.soe = mailbox.foe = mailbox.voe = true;
  mailbox.data_link_layer = true;
  mailbox.send.short_send = true;
  mailbox.bootstrap_send = MailboxChannel{0x1000, 256, true};
  mailbox.bootstrap_receive = MailboxChannel{0x1100, 256, false};
  mailbox.poll_time_ms.reset();
  mailbox.status_bit_address = 1;
  mailbox.soe_commands = {{{Transition::kPS}, 3, 1, 0x800F, 0x40, 2, {1, 2, 3, 4}, 300, false, true, "telegram type"}};
  mailbox.aoe_commands = {message({1, 2}, "set NetId")};
  mailbox.aoe_net_id = "5.1.2.3.3.1";
  mailbox.eoe_commands = {message({0x02, 0x00}, "set IP parameter")};
  mailbox.eoe_disabled = true;
  mailbox.foe_commands = {message({}, "nothing to say")};
  mailbox.voe_commands = {message({9}, "vendor's")};
  mailbox.voe_commands[0].enabled = mailbox.voe_commands[0].fixed = false;
}

inline void fill_pdo(Pdo& pdo) {
  pdo.is_virtual = pdo.mandatory = pdo.overwritten_by_module = true;
  pdo.sync_unit = 2;
  pdo.order = 3;
  pdo.os_factor = 4;
  pdo.os_min = 1;
  pdo.os_max = 8;
  pdo.os_index_increment = 16;
  pdo.exclude = {0x1600, 0x1601};
  auto& entry = pdo.entries.front();
  entry.fixed = true;
  entry.comment = "scaled by the drive";
  entry.scale = "+/-10";
  entry.swap = 1;
}

/// Has every element and attribute of the schema.
inline NetworkConfig everything() {
  NetworkConfig config = compile(sample::small_machine()).value().config;
  fill_master(config.master);
  auto& slave = config.slaves.back();
  slave.identification = Identification{0x0134, 0x8000'0001};
  slave.product_revision = "SV-1-0002-0018";
  slave.other_ports = {{1, 1001, 7}, {2, {}, {}}, {3, 1002, {}}};
  slave.send_parts = {{0, 16, 1U << 2}, {16, 32, 1U << 4 | 1U << 5}};
  slave.send = ImageRange{0, 48};
  slave.sync_managers.front().watchdog = 100;
  slave.sync_managers.front().description.is_virtual = true;
  fill_mailbox(slave.mailbox.value());
  fill_pdo(slave.pdos.front().pdo);
  slave.dc->potential_reference_clock = true;
  InitCmd identify;
  identify.transitions = {Transition::kIP};
  identify.command = Command::kAprd;
  identify.ado = 0x0012;
  identify.data = {0, 0};
  identify.validate = InitCmdValidate{{7, 0}, {0xFF, 0xFF}, 100};
  slave.hot_connect = HotConnectConfig{"Tool", 1, {identify}};
  CyclicTask& task = config.cyclic.front();
  task.comment = "axis task";
  task.priority = 4;
  task.task_id = "#x02010020";
  task.frames.front().comment = "frame 1";
  task.frames.front().commands.back().copy_infos = {{8, 16, 32}};
  config.image.inputs.front().comment = "first\nof them";
  return config;
}

}  // namespace syncline::eni
