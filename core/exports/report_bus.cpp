// SPDX-License-Identifier: Apache-2.0
// What the report says of the bus as a whole: clocks and cyclic frames.
#include <fmt/format.h>

#include <algorithm>

#include "config/command_text.h"
#include "config/cyclic_frame.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "exports/exports.h"
#include "exports/html_table.h"
#include "exports/report_sections.h"
#include "findings/finding.h"
#include "protocol/system_time_difference.h"

namespace syncline::exports {
namespace {

std::string clock_of(const NetworkConfig& config) {
  const auto position = config.reference_clock();
  return position ? fmt::format("slave {} ({})", *position, config.slaves[*position].name) : "none";
}

std::string window_of(const SyncWindowSettings& window, bool set) {
  if (!window.enabled) return "not monitored";
  if (!set) return "monitored (BRD 0x092C)";
  return fmt::format("{} (2^{} - 1), settle time {} ms", exact_time_text(sync_window_limit_ns(window.exponent)),
                     window.exponent, window.settle_time_ms);
}

std::string commands_of(const CyclicFrame& frame) {
  std::string text;
  for (const auto& cmd : frame.commands) text += (text.empty() ? "" : ", ") + address_text(cmd);
  return text;
}

}  // namespace

std::string clocks_section(const NetworkConfig& config, bool set) {
  HtmlTable table;
  const auto& dc = config.dc;
  table.row({"Cycle", exact_time_text(config.cycle_time())});
  table.row({"Reference clock", clock_of(config)});
  table.row({"Sync window", window_of(dc.sync_window, set)});
  if (!set) {
    const auto* words = find_finding_words("clock-settings-unknown");
    return table.end() + html_element("p", sentence_of(*words, {})) + "\n";
  }
  table.row({"Distributed clocks", dc.enabled ? "on" : "off"});
  table.row({"Synchronisation of master and reference clock", std::string(dcm_mode_name(dc.dcm.mode))});
  table.row({"Distance from sending to SYNC0", exact_time_text(effective_set_value(dc.dcm, config.cycle_time()))});
  table.row({"Limit of that distance", exact_time_text(effective_dcm_settings(dc.dcm).in_sync_limit)});
  table.row({"Continuous propagation compensation", dc.continuous_propagation_compensation ? "on" : "off"});
  table.row({"System time in frames", dc.show_64bit_system_time ? "64 bits" : "32 bits"});
  return table.end();
}

std::string frames_section(const NetworkConfig& config) {
  HtmlTable table({"Task", "Cycle", "Frame", "Datagrams", "Bytes", "Wire time", "Commands"});
  for (std::size_t i = 0; i < config.cyclic.size(); ++i) {
    const auto& task = config.cyclic[i];
    for (std::size_t j = 0; j < task.frames.size(); ++j) {
      const auto& frame = task.frames[j];
      table.row({std::to_string(i), exact_time_text(task.cycle_time), std::to_string(j),
                 std::to_string(frame.commands.size()), std::to_string(bytes_sent(frame)),
                 exact_time_text(wire_time(frame)), commands_of(frame)});
    }
  }
  const auto need = cycle_need(config, true);
  const auto sum = fmt::format(
      "Wire time at 100 Mbit/s of a cycle in which all tasks are due: {} of {}. Bytes are those of the Ethernet frame "
      "with padding and frame check sequence, times have preamble and gap, too.",
      exact_time_text(need.wire), exact_time_text(config.cycle_time()));
  return table.end() + html_element("p", sum) + "\n";
}

std::string topology_section(const NetworkConfig& config) {
  const auto svg = topology_svg(config);
  return svg.substr(svg.find("<svg"));
}

}  // namespace syncline::exports
