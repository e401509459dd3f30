// SPDX-License-Identifier: Apache-2.0
#include "compile/master_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compile/cyclic_frames.h"
#include "compile/dcm_check.h"
#include "compile/finding_list.h"
#include "compile/task_plan.h"
#include "config/entry_ports.h"

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
      findings.info("dc.enabled",
                    "Distributed clocks are off for the whole bus; the slaves' operation modes do not count.");
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
    findings.warning(
        "dc.reference_clock",
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
    findings.warning("dc.mode",
                     "Master and reference clock run at their own rates: the frame wanders through the "
                     "cycle and meets SYNC0 now and then. Choose bus shift or master shift.");
  }
}

/// Frames of the slower tasks are sent together with those of the base task when their cycle comes.
void check_busiest_cycle(FindingList& findings, const NetworkConfig& config) {
  if (config.cyclic.size() < 2) return;
  Nanoseconds on_wire = 0;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) on_wire += wire_time(frame);
  }
  if (const Nanoseconds cycle = config.cycle_time(); on_wire >= cycle) {
    findings.error("cycle_time_us",
                   fmt::format("When all tasks are due in one cycle their frames take {} of {} us of wire time.",
                               on_wire / kMicrosecond, cycle / kMicrosecond));
  }
}

void check_tasks(FindingList& findings, const MasterSettings& master) {
  for (std::size_t i = 0; i < master.sync_units.size(); ++i) {
    const SyncUnit& unit = master.sync_units[i];
    if (!unit.task.empty() && std::ranges::find(master.tasks, unit.task, &TaskSettings::name) == master.tasks.end()) {
      findings.error(
          fmt::format("sync_unit.{}", i),
          fmt::format("Sync Unit \"{}\" is to run in task \"{}\", which does not exist; it stays in the base task.",
                      unit.name, unit.task));
    }
  }
}

/// Room for the process data below the mailbox-state area, where an address was chosen that lies below it.
void check_logical_start(FindingList& findings, const MasterSettings& master, const NetworkConfig& config) {
  if (!master.image.logical_start) return;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      for (const auto& cmd : frame.commands) {
        const bool is_state = cmd.logical_address == config.master.mailbox_state_start;
        if (!is_logical(cmd.command) || is_state || !config.master.mailbox_state_count) continue;
        const std::uint64_t begin = cmd.logical_address, end = begin + cmd.length();
        const std::uint64_t states = config.master.mailbox_state_start;
        if (begin < states + *config.master.mailbox_state_count / 8U + 1 && end > states) {
          return findings.error("image.logical_start", "The process data lie over the mailbox states at 0x09000000.");
        }
      }
    }
  }
}

void check_sync_units(std::vector<Finding>& out, const MasterSettings& master, const std::vector<SlavePlan>& slaves) {
  for (const SlavePlan& slave : slaves) {
    FindingList findings(out, slave.position);
    const auto check = [&](const std::string& name, const char* key) {
      if (name.empty() || sync_unit_number(master, name) != 0) return;
      findings.error(key, fmt::format("There is no Sync Unit \"{}\"; the unnamed one is used.", name));
    };
    check(slave.settings->output_unit, "sync_unit.outputs");
    check(slave.settings->input_unit, "sync_unit.inputs");
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

/// A slave whose cables are swapped stands behind those at its port A (config/entry_ports.h).
void check_wiring(std::vector<Finding>& out, const std::vector<SlavePlan>& slaves) {
  std::vector<std::optional<PreviousPort>> wiring;
  for (const SlavePlan& slave : slaves) wiring.push_back(slave.settings->previous);
  const auto entries = entry_ports(wiring);
  for (const SlavePlan& slave : slaves) {
    FindingList findings(out, slave.position);
    const auto& previous = wiring[slave.position];
    if (previous) {
      const bool explained = previous->position < slaves.size() && entries[previous->position];
      const bool swapped = explained && *entries[previous->position] != 0;
      if (!explained && previous->position >= slave.position) {
        findings.error("previous", "No wiring puts a slave in front of the one that it hangs on here.");
      } else if (previous->port > 3 || (previous->port == 0 && !swapped)) {
        findings.error("previous", "A slave hangs on port B, C or D of its predecessor.");
      }
    }
    if (entries[slave.position].value_or(0) != 0) {
      findings.warning("previous",
                       "Frames enter it by another port than A. Swap its cables IN and OUT: until then slaves "
                       "behind it stand in front of it, an ENI file cannot tell what hangs on its port A, and "
                       "other masters take its propagation delay wrong.");
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
  check_busiest_cycle(findings, config);
  check_tasks(findings, project.master);
  check_logical_start(findings, project.master, config);
  check_addresses(out, slaves);
  check_wiring(out, slaves);
  check_sync_units(out, project.master, slaves);
}

}  // namespace syncline::compiler
