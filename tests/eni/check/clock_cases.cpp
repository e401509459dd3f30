// SPDX-License-Identifier: Apache-2.0
#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"

namespace syncline::test {
namespace {

void erase_dc(NetworkConfig& c, std::size_t slave) {
  c.slaves[slave].dc.reset();
  std::erase_if(c.slaves[slave].init_cmds, [](const InitCmd& cmd) { return cmd.ado >= 0x0980 && cmd.ado <= 0x09AF; });
}

std::vector<RuleCase> cyclic_cases() {
  return {
      {"ENI-DC-01",
       [](NetworkConfig& c) {
         for (const Command command : {Command::kNop, Command::kArmw, Command::kApwr}) {
           erase_cyclic(c, command, command == Command::kNop ? reg::kReceiveTimePort0 : reg::kSystemTime);
         }
       }},
      {"ENI-DC-02", [](NetworkConfig& c) { erase_cyclic(c, Command::kNop, reg::kReceiveTimePort0); }},
      {"ENI-DC-03", [](NetworkConfig& c) { c.slaves[kDrive].dc->reference_clock = false; }},
      {"ENI-DC-04", [](NetworkConfig& c) { c.slaves[kLastDrive].dc->reference_clock = true; }},
      {"ENI-DC-05",
       [](NetworkConfig& c) {
         cyclic(c, Command::kApwr, reg::kSystemTime).adp = c.slaves[kLastDrive].auto_increment_address;
       }},
      {"ENI-DC-21",
       [](NetworkConfig& c) {
         std::swap(cyclic(c, Command::kArmw, reg::kSystemTime), cyclic(c, Command::kApwr, reg::kSystemTime));
       }},
      {"ENI-DC-06", [](NetworkConfig& c) { erase_dc(c, kLastDrive); }},
      {"ENI-DC-07",
       [](NetworkConfig& c) {
         c.slaves[kDrive].dc->reference_clock = false;
         c.slaves[kLastDrive].dc->reference_clock = true;
         cyclic(c, Command::kArmw, reg::kSystemTime).adp = c.slaves[kLastDrive].auto_increment_address;
         cyclic(c, Command::kApwr, reg::kSystemTime).adp = c.slaves[kLastDrive].auto_increment_address;
       }},
      {"ENI-DC-08", [](NetworkConfig& c) { cyclic(c, Command::kArmw, reg::kSystemTime).data_length = 6; }},
      {"ENI-DC-09", [](NetworkConfig& c) { cyclic(c, Command::kArmw, reg::kSystemTime).states = {AlState::kOp}; }},
      {"ENI-DIA-03",
       [](NetworkConfig& c) {
         CyclicCmd& cmd = cyclic(c, Command::kArmw, reg::kSystemTime);
         cmd.command = Command::kFrmw;
         cmd.adp = c.slaves[kDrive].station_address;
       }},
      {"ENI-WKC-01", [](NetworkConfig& c) { ++*cyclic(c, Command::kLrw).expected_wkc; }},
      {"ENI-WKC-02", [](NetworkConfig& c) { cyclic(c, Command::kBrd, reg::kAlStatus).expected_wkc = 9; }},
      {"ENI-WKC-03", [](NetworkConfig& c) { cyclic(c, Command::kLrw).expected_wkc.reset(); }},
      {"ENI-WKC-04", [](NetworkConfig& c) { command(c, kDrive, Transition::kPS, reg::fmmu(0)).expected_wkc = 2; }},
  };
}

std::vector<RuleCase> slave_clock_cases() {
  return {
      {"ENI-DC-10", [](NetworkConfig& c) { erase_commands(c, kDrive, Transition::kPS, reg::kSync0CycleTime); }},
      {"ENI-DC-11", [](NetworkConfig& c) { command(c, kDrive, Transition::kPS, reg::kSync0CycleTime).data[0] ^= 1; }},
      {"ENI-DC-12", [](NetworkConfig& c) { command(c, kDrive, Transition::kPS, reg::kCyclicUnitControl).data[1] = 5; }},
      {"ENI-DC-13",
       [](NetworkConfig& c) {
         std::swap(command(c, kDrive, Transition::kPS, reg::kCyclicUnitControl),
                   command(c, kDrive, Transition::kPS, reg::kSync0CycleTime));
       }},
      {"ENI-DC-14",
       [](NetworkConfig& c) { erase_commands(c, kDrive, Transition::kPS, reg::kStartTimeCyclicOperation); }},
      {"ENI-DC-15", [](NetworkConfig& c) { c.slaves[kDrive].dc->shift_time = 1000; }},
      {"ENI-DC-16",
       [](NetworkConfig& c) {
         std::erase_if(c.slaves[kDrive].init_cmds, [](const InitCmd& cmd) {
           return cmd.ado == reg::kCyclicUnitControl && (has(cmd, Transition::kSP) || has(cmd, Transition::kSI));
         });
       }},
      {"ENI-DC-17", [](NetworkConfig& c) { c.slaves[kLastDrive].dc.reset(); }},
      {"ENI-DC-18",
       [](NetworkConfig& c) {
         c.slaves[kDrive].dc->cycle_time0 = 300'000;
         auto& data = command(c, kDrive, Transition::kPS, reg::kSync0CycleTime).data;
         store_le(std::span<std::uint8_t>(data), std::uint32_t{300'000});
       }},
      {"ENI-DC-19",
       [](NetworkConfig& c) {
         c.slaves[kDrive].dc->shift_time = 2'000'000;
         auto& data = command(c, kDrive, Transition::kPS, reg::kStartTimeCyclicOperation).data;
         store_le(std::span<std::uint8_t>(data), std::uint32_t{2'000'000});
       }},
      {"ENI-DC-20",
       [](NetworkConfig& c) {
         c.slaves[kDrive].dc->cycle_time1 = 5000;
         auto& data = command(c, kDrive, Transition::kPS, reg::kSync0CycleTime).data;
         store_le(std::span<std::uint8_t>(data).subspan(4), std::uint32_t{5000});
       }},
  };
}

}  // namespace

std::vector<RuleCase> clock_cases() {
  auto all = cyclic_cases();
  const auto more = slave_clock_cases();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace syncline::test
