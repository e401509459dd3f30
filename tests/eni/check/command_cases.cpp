// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"

namespace syncline::test {
namespace {

StartupCommand& start_up(NetworkConfig& c, std::uint16_t index, std::uint8_t sub_index) {
  for (auto& cmd : c.slaves[kDrive].mailbox->coe_commands) {
    if (cmd.command.index == index && cmd.command.sub_index == sub_index) return cmd.command;
  }
  throw std::out_of_range("no such start-up command");
}

StartupCommand object(std::uint16_t index, std::uint8_t sub_index) {
  StartupCommand command;
  command.index = index;
  command.sub_index = sub_index;
  command.data = {1, 0};
  return command;
}

std::vector<RuleCase> coe_cases() {
  return {
      {"ENI-COE-01",
       [](NetworkConfig& c) {
         start_up(c, 0x1C12, 1).data = {0x01, 0x16};
       }},
      {"ENI-COE-02", [](NetworkConfig& c) { c.slaves[kDrive].mailbox->coe_commands.back().ccs = 2; }},
      {"ENI-COE-03",
       [](NetworkConfig& c) {
         start_up(c, 0x1601, 1).data = {0x20, 0x00, 0x7A, 0x60};
       }},
      {"ENI-COE-04",
       [](NetworkConfig& c) {
         std::erase_if(c.slaves[kDrive].mailbox->coe_commands, [](const CoeInitCmd& cmd) {
           return cmd.command.index == 0x1C12 && cmd.command.data == std::vector<std::uint8_t>{0};
         });
       }},
      {"ENI-COE-05", [](NetworkConfig& c) { start_up(c, 0x60C2, 1).data.clear(); }},
      {"ENI-COE-06",
       [](NetworkConfig& c) {
         CoeInitCmd cmd{object(0x2000, 2)};
         cmd.command.complete_access = true;
         c.slaves[kDrive].mailbox->coe_commands.push_back(cmd);
       }},
      {"ENI-COE-07",
       [](NetworkConfig& c) {
         CoeInitCmd cmd{object(0x2000, 1)};
         cmd.command.transitions = {Transition::kII};
         c.slaves[kDrive].mailbox->coe_commands.push_back(cmd);
       }},
      {"ENI-COE-08", [](NetworkConfig& c) { start_up(c, 0x60C2, 1).data = {7}; }},
      {"ENI-TIME-07", [](NetworkConfig& c) { start_up(c, 0x60C2, 1).timeout_ms = 4; }},
      {"ENI-COE-09", [](NetworkConfig& c) { start_up(c, 0x60C2, 1).data.push_back(0); }},
  };
}

std::vector<RuleCase> state_cases() {
  return {
      {"ENI-STATE-01", [](NetworkConfig& c) { erase_commands(c, kDrive, Transition::kSO, reg::kAlControl); }},
      {"ENI-STATE-02", [](NetworkConfig& c) { command(c, kDrive, Transition::kSO, reg::kAlControl).data[0] = 4; }},
      {"ENI-STATE-03", [](NetworkConfig& c) { erase_commands(c, kDrive, Transition::kSO, reg::kAlStatus); }},
      {"ENI-STATE-04",
       [](NetworkConfig& c) { command(c, kDrive, Transition::kSO, reg::kAlStatus, false).validate->data[0] = 4; }},
      {"ENI-STATE-05", [](NetworkConfig& c) { c.slaves[kCoupler].init_cmds.clear(); }},
      {"ENI-ORD-01", [](NetworkConfig& c) { move_to_end(c, kInput, Transition::kPS, reg::sync_manager(0)); }},
      {"ENI-ORD-02", [](NetworkConfig& c) { move_to_end(c, kInput, Transition::kPS, reg::fmmu(0)); }},
      {"ENI-ORD-03", [](NetworkConfig& c) { move_to_end(c, kDrive, Transition::kPS, reg::kCyclicUnitControl); }},
      {"ENI-ORD-04", [](NetworkConfig& c) { move_to_end(c, kInput, Transition::kIP, reg::kStationAddress); }},
      {"ENI-ORD-05",
       [](NetworkConfig& c) {
         auto& commands = c.slaves[kInput].init_cmds;
         commands.erase(std::ranges::find_if(commands, [](const InitCmd& cmd) {
           return has(cmd, Transition::kIP) && cmd.ado == reg::kSiiConfiguration;
         }));
       }},
      {"ENI-ORD-06",
       [](NetworkConfig& c) {
         std::erase_if(c.slaves[kDrive].init_cmds, [](const InitCmd& cmd) {
           return cmd.ado == reg::kSiiConfiguration && cmd.data == std::vector<std::uint8_t>{1};
         });
       }},
      {"ENI-ORD-07",
       [](NetworkConfig& c) { command(c, kInput, Transition::kIP, reg::kStationAddress).data[0] ^= 0x40; }},
      {"ENI-ORD-09", [](NetworkConfig& c) { command(c, kInput, Transition::kIP, reg::kSiiData, false).ado += 8; }},
      {"ENI-ORD-10", [](NetworkConfig& c) { command(c, kInput, Transition::kIP, reg::kSiiConfiguration).ado -= 1; }},
      {"ENI-ORD-08",
       [](NetworkConfig& c) {
         std::erase_if(c.master.init_cmds, [](const InitCmd& cmd) { return cmd.ado == reg::kFmmu; });
       }},
  };
}

}  // namespace

std::vector<RuleCase> command_cases() {
  auto all = coe_cases();
  const auto more = state_cases();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace syncline::test
