// SPDX-License-Identifier: Apache-2.0
#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"

namespace syncline::test {
namespace {

InitCmd alias_check(std::uint8_t alias) {
  InitCmd cmd;
  cmd.command = Command::kAprd;
  cmd.ado = reg::kStationAlias;
  cmd.data = {0, 0};
  cmd.validate = InitCmdValidate{{alias, 0}, {0xFF, 0xFF}, 100};
  return cmd;
}

HotConnectConfig group(const std::string& name, std::uint16_t members, std::vector<InitCmd> identify) {
  return {name, members, std::move(identify)};
}

std::vector<RuleCase> reference_cases() {
  return {
      {"ENI-REF-02",
       [](NetworkConfig& c) {
         c.slaves[kOutput].previous = PreviousPort{kDrive, 1};
       }},
      {"ENI-REF-03", [](NetworkConfig& c) { readdress(c.slaves[kLastDrive], c.slaves[kDrive].station_address); }},
      {"ENI-REF-04", [](NetworkConfig& c) { readdress(c.slaves[kLastDrive], 0); }},
      {"ENI-REF-05",
       [](NetworkConfig& c) {
         SlaveConfig& slave = c.slaves[kLastDrive];
         slave.auto_increment_address = 0x1234;
         for (auto& cmd : slave.init_cmds) {
           if (is_auto_increment(cmd.command)) cmd.adp = 0x1234;
         }
       }},
      {"ENI-REF-06", [](NetworkConfig& c) { c.slaves[kLastDrive].name = c.slaves[kDrive].name; }},
      {"ENI-REF-07",
       [](NetworkConfig& c) { command(c, kLastDrive, Transition::kPS, reg::sync_manager(2)).adp = 1001; }},
      {"ENI-REF-08",
       [](NetworkConfig& c) {
         CyclicCmd cmd = cyclic(c, Command::kBrd, reg::kAlStatus);
         cmd.command = Command::kFprd;
         cmd.adp = 1999;
         cmd.expected_wkc.reset();
         frame(c).push_back(cmd);
       }},
      {"ENI-REF-09", [](NetworkConfig& c) { c.slaves[kLastDrive].previous = c.slaves[kDrive].previous; }},
      {"ENI-REF-11",
       [](NetworkConfig& c) {
         c.slaves[kOutput].previous = PreviousPort{kDrive, 2};
         c.slaves[kDrive].previous = PreviousPort{kInput, 1};
         c.slaves[kLastDrive].previous = PreviousPort{kDrive, 3};
       }},
      {"ENI-REF-10",
       [](NetworkConfig& c) { command(c, kInput, Transition::kIP, reg::kSiiData, false).validate->data[0] ^= 0x10; }},
      {"ENI-REF-12",
       [](NetworkConfig& c) {
         for (const auto slave : {kDrive, kLastDrive}) {
           auto cmd = alias_check(9);
           cmd.transitions = {Transition::kIP};
           cmd.adp = c.slaves[slave].auto_increment_address;
           cmd.validate->mask.clear();
           c.slaves[slave].init_cmds.push_back(cmd);
         }
       }},
      {"ENI-HC-01", [](NetworkConfig& c) { c.slaves[kLastDrive].hot_connect = group("A", 2, {alias_check(7)}); }},
      {"ENI-HC-02",
       [](NetworkConfig& c) {
         InitCmd reads = alias_check(7);
         reads.validate.reset();
         c.slaves[kLastDrive].hot_connect = group("A", 1, {reads});
       }},
      {"ENI-HC-03",
       [](NetworkConfig& c) {
         c.slaves[kDrive].hot_connect = group("A", 1, {alias_check(7)});
         c.slaves[kLastDrive].hot_connect = group("B", 1, {alias_check(7)});
       }},
  };
}

std::vector<RuleCase> pdo_cases() {
  return {
      {"ENI-PDO-01",
       [](NetworkConfig& c) {
         c.slaves[kInput].sync_managers[0].pdos[1] = 0x1AFF;
         c.slaves[kInput].pdos[1].pdo.sync_manager.reset();
       }},
      {"ENI-PDO-02", [](NetworkConfig& c) { c.slaves[kInput].pdos[1].pdo.sync_manager = 3; }},
      {"ENI-PDO-03", [](NetworkConfig& c) { c.slaves[kInput].pdos[0].pdo.exclude = {0x1A01}; }},
      {"ENI-PDO-04", [](NetworkConfig& c) { c.slaves[kDrive].pdos.back().pdo.mandatory = true; }},
      {"ENI-PDO-05", [](NetworkConfig& c) { c.slaves[kInput].pdos.push_back(c.slaves[kInput].pdos[1]); }},
      {"ENI-SM-01", [](NetworkConfig& c) { erase_commands(c, kInput, Transition::kPS, reg::sync_manager(0)); }},
      {"ENI-SM-02", [](NetworkConfig& c) { c.slaves[kDrive].sync_managers[0].description.max_size = 1; }},
      {"ENI-SM-03", [](NetworkConfig& c) { c.slaves[kInput].sync_managers[0].description.start_address = 0x1010; }},
      {"ENI-SM-04", [](NetworkConfig& c) { command(c, kInput, Transition::kPS, reg::sync_manager(0)).data[4] = 0x04; }},
      {"ENI-SM-05",
       [](NetworkConfig& c) { command(c, kDrive, Transition::kPS, reg::sync_manager(3)).data[2] += 1; },
       {"ENI-FMMU-06"}},
      {"ENI-SM-06",
       [](NetworkConfig& c) {
         insert_on_ps(c, kDrive, reg::sync_manager(5), {0x00, 0x02, 4, 0, 0x20, 0, 1, 0});
       }},
      {"ENI-SM-07",
       [](NetworkConfig& c) {
         insert_on_ps(c, kDrive, reg::sync_manager(5), {0x90, 0x11, 4, 0, 0x20, 0, 1, 0});
       }},
      {"ENI-SM-08", [](NetworkConfig& c) { c.slaves[kInput].sync_managers[0].description.enable = false; }},
      {"ENI-SM-09", [](NetworkConfig& c) { c.slaves[kInput].receive->bit_length = 5; }},
  };
}

std::vector<RuleCase> fmmu_cases() {
  return {
      {"ENI-FMMU-01",
       [](NetworkConfig& c) {
         Fmmu other = fmmu(c, kDrive, 1);
         other.read = other.write = false;
         insert_on_ps(c, kDrive, reg::fmmu(5), bytes(other));
       }},
      {"ENI-FMMU-02",
       [](NetworkConfig& c) {
         Fmmu other = fmmu(c, kDrive, 1);
         other.logical_start = 0x2000'0000;
         insert_on_ps(c, kDrive, reg::fmmu(5), bytes(other));
       }},
      {"ENI-FMMU-03", [](NetworkConfig& c) { cyclic(c, Command::kLrw).states = {AlState::kOp}; }},
      {"ENI-FMMU-04",
       [](NetworkConfig& c) {
         Fmmu other = fmmu(c, kOutput, 0);
         other.write = false;
         other.read = true;
         other.physical_start = 0x3000;
         insert_on_ps(c, kOutput, reg::fmmu(5), bytes(other));
         ++*cyclic(c, Command::kLrw).expected_wkc;
       }},
      {"ENI-FMMU-05",
       [](NetworkConfig& c) {
         Fmmu other = fmmu(c, kOutput, 0);
         other.write = false;
         other.read = true;
         insert_on_ps(c, kOutput, reg::fmmu(5), bytes(other));
         ++*cyclic(c, Command::kLrw).expected_wkc;
       }},
      {"ENI-FMMU-06", [](NetworkConfig& c) { command(c, kDrive, Transition::kPS, reg::fmmu(1)).data[4] -= 1; }},
      {"ENI-FMMU-07",
       [](NetworkConfig& c) {
         Fmmu other = fmmu(c, kInput, 0);
         other.logical_start = fmmu(c, kLastDrive, 1).logical_start;
         insert_on_ps(c, kInput, reg::fmmu(5), bytes(other));
       }},
      {"ENI-FMMU-08",
       [](NetworkConfig& c) {
         Fmmu other = fmmu(c, kOutput, 0);
         other.logical_start = fmmu(c, kLastDrive, 0).logical_start;
         insert_on_ps(c, kOutput, reg::fmmu(5), bytes(other));
       }},
      {"ENI-FMMU-09",
       [](NetworkConfig& c) {
         erase_commands(c, kInput, Transition::kPS, reg::fmmu(0));
         --*cyclic(c, Command::kLrw).expected_wkc;
       }},
  };
}

std::vector<RuleCase> mailbox_cases() {
  return {
      {"ENI-MBX-01", [](NetworkConfig& c) { c.slaves[kDrive].mailbox->send.length = 8; }},
      {"ENI-MBX-02",
       [](NetworkConfig& c) { c.slaves[kDrive].mailbox->send.start = c.slaves[kDrive].mailbox->receive.start; }},
      {"ENI-MBX-03",
       [](NetworkConfig& c) { erase_command(c, kDrive, command(c, kDrive, Transition::kIP, reg::sync_manager(0))); }},
      {"ENI-MBX-04", [](NetworkConfig& c) { command(c, kDrive, Transition::kIP, reg::sync_manager(0)).data[2] = 64; }},
      {"ENI-MBX-05", [](NetworkConfig& c) { c.slaves[kDrive].mailbox->status_bit_address.reset(); }},
      {"ENI-MBX-06", [](NetworkConfig& c) { c.slaves[kDrive].mailbox->coe = false; }},
      {"ENI-MBX-07", [](NetworkConfig& c) { c.master.mailbox_state_count = 1; }},
      {"ENI-MBX-08",
       [](NetworkConfig& c) {
         c.slaves[kLastDrive].mailbox->status_bit_address = 0;
         Fmmu bit = Fmmu::decode(
             std::span<const std::uint8_t, 16>(command(c, kLastDrive, Transition::kIP, reg::fmmu(2)).data));
         bit.logical_start_bit = bit.logical_stop_bit = 0;
         command(c, kLastDrive, Transition::kIP, reg::fmmu(2)).data = bytes(bit);
       },
       {"ENI-FMMU-07"}},
      {"ENI-MBX-09",
       [](NetworkConfig& c) { command(c, kDrive, Transition::kIP, reg::sync_manager(0)).data[4] = 0x22; }},
      {"ENI-MBX-10",
       [](NetworkConfig& c) {
         c.slaves[kDrive].mailbox->coe = c.slaves[kDrive].mailbox->foe = false;
         c.slaves[kDrive].mailbox->coe_commands.clear();
       }},
  };
}

}  // namespace

std::vector<RuleCase> slave_cases() {
  std::vector<RuleCase> all;
  for (const auto& part : {reference_cases(), pdo_cases(), fmmu_cases(), mailbox_cases()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace syncline::test
