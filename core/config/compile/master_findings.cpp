// SPDX-License-Identifier: Apache-2.0
#include "config/compile/master_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "config/compile/cyclic_frames.h"
#include "config/compile/finding_list.h"
#include "config/dcm_check.h"

namespace syncline::compiler {
namespace {

void check_cycle(FindingList& findings, const Project& project, const NetworkConfig& config) {
  const Nanoseconds cycle = project.master.cycle_time;
  if (cycle % kMicrosecond != 0) {
    findings.warning("cycle_time_us",
                     fmt::format("An ENI file holds whole microseconds: {} ns is rounded there. Masters that take the "
                                 "cycle from the file run at another rate than the SYNC signals.",
                                 cycle));
  }
  Nanoseconds on_wire = 0;
  for (const auto& frame : config.cyclic.front().frames) {
    on_wire += wire_time(frame);
  }
  if (on_wire >= cycle) {
    findings.error("cycle_time_us", fmt::format("The cyclic frames take {} us of wire time, the cycle is {} us.",
                                                on_wire / kMicrosecond, cycle / kMicrosecond));
  } else if (on_wire * 10 >= cycle * 8) {
    findings.warning("cycle_time_us",
                     fmt::format("The cyclic frames take {} of {} us of wire time; mailbox traffic has little room.",
                                 on_wire / kMicrosecond, cycle / kMicrosecond));
  }
}

void check_reference_clock(FindingList& findings, const Project& project, const std::vector<SlavePlan>& slaves) {
  const auto chosen = project.master.dc.reference_clock;
  const auto first = std::ranges::find_if(slaves, &SlavePlan::dc_commands);
  if (!project.master.dc.enabled) {
    const bool wanted = std::ranges::any_of(slaves, [](const SlavePlan& s) { return !s.settings->dc.op_mode.empty(); });
    if (wanted) {
      findings.info("dc.enabled", "Distributed clocks are off for the whole bus; the slaves' operation modes do not count.");
    }
    return;
  }
  if (!chosen || project.master.dc.first_slave_is_reference_clock) {
    return;
  }
  if (*chosen >= slaves.size()) {
    findings.error("dc.reference_clock", fmt::format("There is no slave at position {}.", *chosen));
  } else if (!slaves[*chosen].device().dc) {
    findings.error("dc.reference_clock",
                   fmt::format("{} has no distributed clock according to its ESI and cannot be the reference.",
                               slaves[*chosen].settings->name));
  } else if (first != slaves.end() && first->position < *chosen) {
    findings.warning("dc.reference_clock",
                     fmt::format("{} stands before the reference clock in the frame, so it gets the time one cycle late "
                                 "and stays off. Choose the first slave with DC.",
                                 first->settings->name));
  }
}

void check_dc_settings(FindingList& findings, const Project& project, const std::vector<SlavePlan>& slaves,
                       const NetworkConfig& config) {
  const DcMasterSettings& dc = project.master.dc;
  const auto dc_slaves = std::ranges::count_if(slaves, &SlavePlan::dc_commands);
  if (dc.enabled && dc.sync_window.enabled && dc_slaves < 2) {
    findings.info("dc.sync_window", fmt::format("Sync window monitoring compares slaves with the reference clock; "
                                                "{} slave(s) with DC leave nothing to compare.",
                                                dc_slaves));
  }
  constexpr std::string_view kMaster = "master.";
  for (const auto& problem : dcm_problems(config)) {
    if (!problem.key.starts_with(kMaster)) continue;  // SYNC cycles are found at their slaves
    findings.error(problem.key.substr(kMaster.size()), problem.detail + ".");
  }
  if (dc.enabled && dc_slaves > 0 && dc.dcm.mode == DcmMode::kOff) {
    findings.warning("dc.mode", "Master and reference clock run at their own rates: the frame wanders through the "
                                "cycle and meets SYNC0 now and then. Choose bus shift or master shift.");
  }
}

void check_addresses(std::vector<Finding>& out, const std::vector<SlavePlan>& slaves) {
  std::map<std::uint16_t, const SlavePlan*> used;
  for (const SlavePlan& slave : slaves) {
    FindingList findings(out, slave.position);
    const std::uint16_t address = slave.settings->station_address;
    if (address == 0) {
      findings.error("station_address", "Station address 0 is that of a slave without address.");
    } else if (const auto [other, is_new] = used.emplace(address, &slave); !is_new) {
      findings.error("station_address",
                     fmt::format("Station address {} is that of {} too.", address, other->second->settings->name));
    }
  }
}

}  // namespace

void find_master_problems(std::vector<Finding>& out, const Project& project, const std::vector<SlavePlan>& slaves,
                          const NetworkConfig& config) {
  FindingList findings(out, -1);
  check_cycle(findings, project, config);
  check_reference_clock(findings, project, slaves);
  check_dc_settings(findings, project, slaves, config);
  check_addresses(out, slaves);
}

}  // namespace syncline::compiler
