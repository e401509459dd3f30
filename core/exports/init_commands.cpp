// SPDX-License-Identifier: Apache-2.0
#include "exports/init_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/command_text.h"
#include "config/init_cmd.h"
#include "config/mailbox_config.h"
#include "config/network_config.h"
#include "config/startup_messages.h"
#include "exports/csv_row.h"
#include "exports/exports.h"
#include "protocol/object_value.h"
#include "protocol/register_layout.h"
#include "protocol/soe.h"

namespace syncline::exports {
namespace {

constexpr unsigned kMostUnits = 16;  // FMMUs and SyncManagers of an ESC

std::string bytes_text(const std::vector<std::uint8_t>& bytes) { return value_text(kBytesType, bytes); }

std::string register_target(std::uint16_t address) {
  static const auto layouts = reg::register_layouts(kMostUnits, kMostUnits);
  const auto after = std::ranges::upper_bound(layouts, address, {}, &reg::RegisterLayout::address);
  auto text = fmt::format("0x{:04X}", address);
  if (after == layouts.begin()) return text;
  const auto& layout = *std::prev(after);
  return address < layout.address + layout.length ? text + " " + layout.name : text;
}

std::string validate_text(const InitCmdValidate& validate) {
  constexpr std::pair<ValidateType, const char*> kSigns[] = {
      {ValidateType::kEqual, "="},        {ValidateType::kNotEqual, "<>"}, {ValidateType::kGreaterOrEqual, ">="},
      {ValidateType::kLessOrEqual, "<="}, {ValidateType::kGreater, ">"},   {ValidateType::kLess, "<"}};
  const auto sign = std::ranges::find(kSigns, validate.type, &std::pair<ValidateType, const char*>::first);
  if (sign == std::end(kSigns)) return {};
  auto text = fmt::format("{} {}", sign->second, bytes_text(validate.data));
  if (!validate.mask.empty()) text += fmt::format(" (mask {})", bytes_text(validate.mask));
  return text;
}

InitCommandRow row_of(int slave, const InitCmd& cmd) {
  InitCommandRow row{
      .slave = slave,
      .transitions = transitions_text(cmd.transitions),
      .protocol = "ESC",
      .command = std::string(command_name(cmd.command)),
      .target = is_logical(cmd.command) ? fmt::format("0x{:08X}", cmd.logical_address) : register_target(cmd.ado),
      .address = is_logical(cmd.command) ? cmd.logical_address : cmd.ado,
      .data = cmd.data,
      .length = cmd.data_length,
      .expected_wkc = cmd.expected_wkc,
      .retries = cmd.retries,
      .before_slave = cmd.before_slave,
      .comment = cmd.comment};
  if (cmd.validate) {
    row.validate = validate_text(*cmd.validate);
    row.timeout_ms = cmd.validate->timeout_ms;
  }
  if (cmd.timeout_ms) row.timeout_ms = *cmd.timeout_ms;
  return row;
}

InitCommandRow row_of(int slave, const CoeInitCmd& cmd) {
  const auto& command = cmd.command;
  auto target = fmt::format("0x{:04X}:{:02X}", command.index, command.sub_index);
  if (command.complete_access) target += " (complete)";
  return {.slave = slave,
          .transitions = transitions_text(command.transitions),
          .protocol = "CoE",
          .command = cmd.ccs == 1 ? "download" : "upload",
          .target = std::move(target),
          .address = command.index,
          .sub_index = command.sub_index,
          .data = command.data,
          .timeout_ms = command.timeout_ms,
          .enabled = command.enabled,
          .comment = command.comment};
}

InitCommandRow row_of(int slave, const SoeInitCmd& cmd) {
  return {.slave = slave,
          .transitions = transitions_text(cmd.transitions),
          .protocol = "SoE",
          .command = cmd.op_code == 3 ? "write" : "read",
          .target = fmt::format("drive {} {}", cmd.drive_no, soe::idn_text(cmd.idn)),
          .address = cmd.idn,
          .data = cmd.data,
          .timeout_ms = cmd.timeout_ms,
          .enabled = cmd.enabled,
          .comment = cmd.comment};
}

InitCommandRow row_of(int slave, std::string_view protocol, const MailboxInitCmd& cmd) {
  return {.slave = slave,
          .transitions = transitions_text(cmd.transitions),
          .protocol = std::string(protocol),
          .command = "send",
          .data = cmd.data,
          .timeout_ms = cmd.timeout_ms,
          .enabled = cmd.enabled,
          .comment = cmd.comment};
}

void add_mailbox(std::vector<InitCommandRow>& rows, int slave, const MailboxConfig& mailbox) {
  for (const auto& cmd : mailbox.coe_commands) rows.push_back(row_of(slave, cmd));
  for (const auto& cmd : mailbox.soe_commands) rows.push_back(row_of(slave, cmd));
  for (const auto& protocol : kMessageProtocols) {
    for (const auto& cmd : mailbox.*protocol.commands) rows.push_back(row_of(slave, protocol.name, cmd));
  }
}

}  // namespace

std::vector<InitCommandRow> init_commands(const NetworkConfig& config) {
  std::vector<InitCommandRow> rows;
  for (const auto& cmd : config.master.init_cmds) rows.push_back(row_of(-1, cmd));
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    const auto& slave = config.slaves[i];
    const auto position = static_cast<int>(i);
    for (const auto& cmd : slave.init_cmds) rows.push_back(row_of(position, cmd));
    if (slave.mailbox) add_mailbox(rows, position, *slave.mailbox);
  }
  return rows;
}

std::string init_commands_csv(const NetworkConfig& config) {
  std::string out =
      "slave,slave_name,transitions,before_slave,protocol,command,target,data,length,expected_wkc,validate,timeout_ms,"
      "retries,enabled,comment\r\n";
  for (const auto& one : init_commands(config)) {
    CsvRow row;
    one.slave < 0 ? row.empty().text("master")
                  : row.number(one.slave).text(config.slaves[static_cast<std::size_t>(one.slave)].name);
    row.text(one.transitions).number(one.before_slave ? 1 : 0).text(one.protocol).text(one.command).text(one.target);
    row.text(bytes_text(one.data)).number(one.length.value_or(static_cast<std::uint16_t>(one.data.size())));
    one.expected_wkc ? row.number(*one.expected_wkc) : row.empty();
    row.text(one.validate).number(one.timeout_ms).number(one.retries).number(one.enabled ? 1 : 0).text(one.comment);
    out += row.end();
  }
  return out;
}

}  // namespace syncline::exports
