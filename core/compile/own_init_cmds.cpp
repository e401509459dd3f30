// SPDX-License-Identifier: Apache-2.0
#include "compile/own_init_cmds.h"

#include "compile/init_cmd_builder.h"
#include "config/register_command.h"

namespace syncline::compiler {
namespace {

InitCmd own_cmd(const RegisterCommand& own, Command read, Command write, std::uint16_t adp) {
  InitCmd cmd;
  cmd.transitions = own.transitions;
  cmd.comment = own.comment;
  cmd.command = own.read ? read : write;
  cmd.adp = adp;
  cmd.ado = own.address;
  cmd.data = own.data;
  cmd.retries = InitCmdBuilder::kDefaultRetries;
  if (own.read && !own.expected.empty()) {
    cmd.validate = InitCmdValidate{own.expected, own.mask, own.timeout_ms, ValidateType::kEqual, false};
  }
  return cmd;
}

}  // namespace

std::vector<InitCmd> own_slave_cmds(const std::vector<RegisterCommand>& commands, std::uint16_t station) {
  std::vector<InitCmd> cmds;
  for (const RegisterCommand& own : commands) {
    if (!own.enabled) continue;
    cmds.push_back(own_cmd(own, Command::kFprd, Command::kFpwr, station));
    cmds.back().expected_wkc = 1;
  }
  return cmds;
}

std::vector<InitCmd> own_master_cmds(const std::vector<RegisterCommand>& commands) {
  std::vector<InitCmd> cmds;
  for (const RegisterCommand& own : commands) {
    if (!own.enabled) continue;
    cmds.push_back(own_cmd(own, Command::kBrd, Command::kBwr, 0));
    cmds.back().before_slave = !own.after_slaves;
  }
  return cmds;
}

}  // namespace syncline::compiler
