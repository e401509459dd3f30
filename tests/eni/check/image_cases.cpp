// SPDX-License-Identifier: Apache-2.0
#include "config/cyclic_frame.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "eni/check/check_bed.h"
#include "eni/check/rule_cases.h"
#include "protocol/al_state.h"
#include "protocol/command.h"

namespace syncline::test {
namespace {

/// A read of the last drive's memory that makes the frame longer.
void lengthen_frame(NetworkConfig& c, std::uint16_t bytes) {
  CyclicCmd cmd;
  cmd.states = {AlState::kOp};
  cmd.command = Command::kFprd;
  cmd.adp = c.slaves[kLastDrive].station_address;
  cmd.ado = 0x1000;
  cmd.data_length = bytes;
  frame(c).push_back(cmd);
}

std::vector<RuleCase> frame_cases() {
  return {
      {"ENI-FRM-01", [](NetworkConfig& c) { lengthen_frame(c, 1470); }},
      {"ENI-FRM-02", [](NetworkConfig& c) { lengthen_frame(c, 0); }},
      {"ENI-FRM-03", [](NetworkConfig& c) { erase_cyclic(c, Command::kBrd, reg::kAlStatus); }},
      {"ENI-FRM-04",
       [](NetworkConfig& c) {
         CyclicCmd again = cyclic(c, Command::kLrw);
         again.input_offset = again.output_offset = c.image.input_bytes;
         c.image.input_bytes += again.length();
         c.image.output_bytes += again.length();
         frame(c).insert(frame(c).begin(), again);
       }},
      {"ENI-TIME-01",
       [](NetworkConfig& c) { command(c, kInput, Transition::kIP, reg::kSiiData, false).validate->timeout_ms = 0; }},
      {"ENI-TIME-02",
       [](NetworkConfig& c) { command(c, kInput, Transition::kPS, reg::kAlStatus, false).validate->timeout_ms = 50; }},
      {"ENI-TIME-03",
       [](NetworkConfig& c) {
         lengthen_frame(c, 1000);
         c.cyclic[0].cycle_time = 50 * kMicrosecond;
       }},
      {"ENI-TIME-04",
       [](NetworkConfig& c) {
         lengthen_frame(c, 1000);
         c.cyclic[0].cycle_time = 100 * kMicrosecond;
       }},
      // 98 us on the wire, and 1 us in each of the slaves.
      {"ENI-TIME-08",
       [](NetworkConfig& c) {
         lengthen_frame(c,
                        static_cast<std::uint16_t>((98 * kMicrosecond - wire_time(c.cyclic[0].frames[0])) / 80 - 12));
         c.cyclic[0].cycle_time = 100 * kMicrosecond;
       }},
      {"ENI-TIME-05", [](NetworkConfig& c) { c.cyclic[0].cycle_time = 20 * kMicrosecond; }},
      {"ENI-TIME-06",
       [](NetworkConfig& c) {
         CyclicTask slow;
         slow.cycle_time = 1500 * kMicrosecond;
         slow.frames = {{{cyclic(c, Command::kBrd, reg::kAlStatus)}}};
         c.cyclic.push_back(slow);
       }},
  };
}

std::vector<RuleCase> variable_cases() {
  return {
      {"ENI-IMG-01", [](NetworkConfig& c) { c.image.inputs[0].bit_offset = c.image.input_bytes * 8; }},
      {"ENI-IMG-02",
       [](NetworkConfig& c) {
         c.image.inputs.push_back({"InfoData.State", "UINT", "", 16, c.image.input_bytes * 8});
       },
       {"ENI-DIA-02"},
       true},
      {"ENI-IMG-03", [](NetworkConfig& c) { c.image.inputs[1].bit_offset = c.image.inputs[0].bit_offset; }},
      {"ENI-IMG-04", [](NetworkConfig& c) { c.slaves[kLastDrive].receive->bit_length += 100'000; }, {"ENI-SM-09"}},
      {"ENI-IMG-05",
       [](NetworkConfig& c) { c.slaves[kLastDrive].receive->bit_start = c.slaves[kDrive].receive->bit_start; },
       {"ENI-IMG-10"}},
      {"ENI-IMG-06", [](NetworkConfig& c) { c.image.inputs[1].name = c.image.inputs[0].name; }},
      {"ENI-IMG-07", [](NetworkConfig& c) { c.image.inputs[0].data_type = "UINT"; }},
      {"ENI-IMG-08", [](NetworkConfig& c) { cyclic(c, Command::kLrw).input_offset += 1000; }, {"ENI-IMG-10"}},
      {"ENI-IMG-09", [](NetworkConfig& c) { cyclic(c, Command::kLrd).input_offset = 0; }},
      {"ENI-IMG-10", [](NetworkConfig& c) { c.slaves[kLastDrive].send->bit_start += 8; }},
      {"ENI-IMG-11",
       [](NetworkConfig& c) {
         cyclic(c, Command::kLrw).copy_infos = {{0, c.image.output_bytes * 8, 8}};
       }},
      {"ENI-IMG-12",
       [](NetworkConfig& c) {
         c.image.inputs.push_back({"Inputs.Frm0WcState", "UINT", "", 16, c.image.input_bytes * 8 - 16});
         c.image.inputs.push_back({"Drive.WcState", "BOOL", "", 1, c.image.input_bytes * 8 - 16});
       },
       {"ENI-DIA-02"},
       true},
      {"ENI-DIA-01", [](NetworkConfig& c) { c.cyclic[0].cycle_time_given = false; }},
      {"ENI-DIA-02", [](NetworkConfig&) {}, {}, true},
      {"ENI-DIA-04",
       [](NetworkConfig& c) { erase_commands(c, kInput, Transition::kIP, reg::kSiiData); },
       {"ENI-ORD-09"}},
  };
}

}  // namespace

std::vector<RuleCase> image_cases() {
  auto all = frame_cases();
  const auto more = variable_cases();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace syncline::test
