// SPDX-License-Identifier: Apache-2.0
#include "exports/init_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "compile/compile.h"
#include "exports/exports.h"
#include "tests/support/sample_devices.h"

namespace syncline::exports {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

InitCmd command(Command what, std::uint16_t ado, std::vector<Transition> transitions) {
  InitCmd result;
  result.transitions = std::move(transitions);
  result.command = what;
  result.adp = 1001;
  result.ado = ado;
  return result;
}

/// One command of each kind.
NetworkConfig every_kind() {
  NetworkConfig config;
  config.master.init_cmds = {command(Command::kBwr, 0x0120, {Transition::kIP})};
  auto& slave = config.slaves.emplace_back();
  slave.name = "Axis, left";
  auto request = command(Command::kFprd, 0x0130, {Transition::kIP, Transition::kBI});
  request.comment = "checks the state";
  request.data_length = 2;
  request.expected_wkc = 1;
  request.retries = 3;
  request.validate = InitCmdValidate{{0x02, 0x00}, {0x1F, 0x00}, 3000, ValidateType::kGreaterOrEqual};
  auto early = command(Command::kFpwr, 0x5F00, {Transition::kPS});
  early.before_slave = true;
  early.data = {0xAB};
  auto logical = command(Command::kLwr, 0, {Transition::kSO});
  logical.logical_address = 0x10000;
  slave.init_cmds = {request, early, logical};
  auto& mailbox = slave.mailbox.emplace();
  CoeInitCmd assign;
  assign.command.index = 0x1C12;
  assign.command.complete_access = true;
  assign.command.data = {1, 0, 0, 0x16};
  assign.command.enabled = false;
  mailbox.coe_commands = {assign};
  auto& drive = mailbox.soe_commands.emplace_back();
  drive.drive_no = 1;
  drive.idn = 0xA011;
  mailbox.eoe_commands.emplace_back().timeout_ms = 100;
  return config;
}

TEST(InitCommands, SayWhatIsSentToWhomAndWhatHasToComeBack) {
  const auto rows = init_commands(every_kind());
  ASSERT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[0].slave, -1);
  EXPECT_EQ(rows[0].command, "BWR");
  EXPECT_THAT(rows[0].target, StartsWith("0x0120 AL"));
  EXPECT_EQ(rows[1].transitions, "IP,BI");
  EXPECT_EQ(rows[1].protocol, "ESC");
  EXPECT_THAT(rows[1].target, StartsWith("0x0130 AL status"));
  EXPECT_EQ(rows[1].validate, ">= 02 00 (mask 1f 00)");
  EXPECT_EQ(rows[1].timeout_ms, 3000U);
  EXPECT_EQ(rows[1].expected_wkc, 1);
  EXPECT_EQ(rows[1].length, 2);
  EXPECT_EQ(rows[2].target, "0x5F00") << "no register that has a name";
  EXPECT_TRUE(rows[2].before_slave);
  EXPECT_EQ(rows[3].target, "0x00010000");
  EXPECT_EQ(rows[4].target, "0x1C12:00 (complete)");
  EXPECT_FALSE(rows[4].enabled);
  EXPECT_EQ(rows[5].target, "drive 1 P-2-0017");
  EXPECT_EQ(rows[6].protocol, "EoE");
}

TEST(InitCommands, AreATableForOtherPrograms) {
  const auto csv = init_commands_csv(every_kind());
  EXPECT_THAT(csv, StartsWith("slave,slave_name,transitions,before_slave,protocol,command,target,data,length,"));
  EXPECT_THAT(csv, HasSubstr("\r\n,master,IP,0,ESC,BWR,"));
  EXPECT_THAT(csv, HasSubstr("0,\"Axis, left\",\"IP,BI\",0,ESC,FPRD,"));
  EXPECT_THAT(csv, HasSubstr(",1,>= 02 00 (mask 1f 00),3000,3,1,checks the state\r\n"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 8);
}

TEST(InitCommands, OfAMachineAreAllThatItsConfigurationHas) {
  const auto config = compile(sample::small_machine()).value().config;
  std::size_t count = config.master.init_cmds.size();
  for (const auto& slave : config.slaves) {
    count += slave.init_cmds.size();
    if (slave.mailbox) count += slave.mailbox->coe_commands.size() + slave.mailbox->eoe_commands.size();
  }
  EXPECT_EQ(init_commands(config).size(), count);
}

}  // namespace
}  // namespace syncline::exports
