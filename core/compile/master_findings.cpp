// SPDX-License-Identifier: Apache-2.0
#include "compile/master_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compile/cyclic_frames.h"
#include "compile/dcm_check.h"
#include "compile/finding_list.h"
#include "compile/slave_plan.h"
#include "config/entry_ports.h"
#include "config/frame_time.h"
#include "config/master_settings.h"
#include "config/project.h"
#include "config/sync_unit_cycle.h"

namespace syncline::compiler {
namespace {

void check_cycle(FindingList& findings, const Project& project, const NetworkConfig& config) {
  const std::size_t slaves = config.slaves.size();
  const Nanoseconds cycle = project.master.cycle_time;
  if (cycle % kMicrosecond != 0) {
    findings.add("cycle-not-whole-microseconds", fig::time<"cycle">(cycle));
  }
  const auto need = cycle_need(config);
  const auto wire = fig::time<"wire">(need.wire);
  const auto length = fig::time<"cycle">(cycle);
  if (need.wire >= cycle) {
    findings.add("cycle-too-short", wire, length);
  } else if (need.all() > cycle) {
    // What slaves need is an estimate, and stops nobody.
    findings.add_as(Severity::kWarning, "cycle-too-short/travel", wire, length, fig::time<"needed">(need.all()),
                    fig::time<"travel">(need.travel), fig::count<"slaves">(slaves));
  } else if (need.wire * 10 >= cycle * 8) {
    findings.add("cycle-nearly-full", wire, length);
  }
}

void check_reference_clock(FindingList& findings, const Project& project, const std::vector<SlavePlan>& slaves) {
  const auto chosen = project.master.dc.reference_clock;
  const auto first = std::ranges::find_if(slaves, &SlavePlan::dc_commands);
  if (!project.master.dc.enabled) {
    const bool wanted = std::ranges::any_of(slaves, [](const SlavePlan& s) { return !s.settings->dc.op_mode.empty(); });
    if (wanted) {
      findings.add("dc-switched-off");
    }
    return;
  }
  if (!chosen || project.master.dc.first_slave_is_reference_clock) {
    return;
  }
  if (*chosen >= slaves.size()) {
    findings.add("reference-clock-missing", fig::number<"position">(*chosen));
  } else if (!slaves[*chosen].device().dc) {
    findings.add("reference-clock-without-dc", fig::text<"name">(slaves[*chosen].settings->name));
  } else if (first != slaves.end() && first->position < *chosen) {
    findings.add("reference-clock-behind", fig::text<"name">(first->settings->name));
  }
}

void check_dc_settings(FindingList& findings, const Project& project, const std::vector<SlavePlan>& slaves,
                       const NetworkConfig& config) {
  const DcMasterSettings& dc = project.master.dc;
  const auto dc_slaves = std::ranges::count_if(slaves, &SlavePlan::dc_commands);
  if (dc.enabled && dc.sync_window.enabled && dc_slaves < 2) {
    findings.add("nothing-to-compare", fig::count<"slaves">(dc_slaves));
  }
  constexpr std::string_view kMaster = "master.";
  for (const auto& problem : dcm_problems(config)) {
    if (!problem.finding.place.key.starts_with(kMaster)) continue;  // SYNC cycles are found at their slaves
    findings.take(problem.finding);
  }
  if (dc.enabled && dc_slaves > 0 && dc.dcm.mode == DcmMode::kOff) {
    findings.add("master-not-synchronised");
  }
}

/// Frames of the slower tasks are sent together with those of the base task when their cycle comes.
void check_busiest_cycle(FindingList& findings, const NetworkConfig& config) {
  if (config.cyclic.size() < 2) return;
  const Nanoseconds on_wire = cycle_need(config, true).wire;
  if (const Nanoseconds cycle = config.cycle_time(); on_wire >= cycle) {
    findings.add("cycle-too-short/busiest", fig::time<"wire">(on_wire), fig::time<"cycle">(cycle));
  }
}

void check_tasks(FindingList& findings, const MasterSettings& master) {
  for (std::size_t i = 0; i < master.sync_units.size(); ++i) {
    const SyncUnit& unit = master.sync_units[i];
    if (!unit.task.empty() && std::ranges::find(master.tasks, unit.task, &TaskSettings::name) == master.tasks.end()) {
      findings.add_at(fmt::format("sync_unit.{}", i), "sync-unit-without-task", fig::text<"unit">(unit.name),
                      fig::text<"task">(unit.task));
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
          return findings.add("process-data-over-mailbox-states");
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
      findings.add_at(key, "sync-unit-missing", fig::text<"unit">(name));
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
      findings.add("station-address-zero");
    } else if (const auto [other, is_new] = used.emplace(address, &slave); !is_new) {
      findings.add("station-address-twice", fig::number<"address">(address),
                   fig::text<"name">(other->second->settings->name));
    }
  }
}

/// Each check of an alias, and each hot-connect group that is found by one.
void check_aliases(std::vector<Finding>& out, const std::vector<SlavePlan>& slaves) {
  std::map<std::uint16_t, const SlavePlan*> used;
  for (const SlavePlan& slave : slaves) {
    const SlaveSettings& settings = *slave.settings;
    const bool found_by_alias = (!settings.hot_connect.empty() || settings.optional) && !settings.check.device_id;
    if (settings.alias == 0 || !(settings.check.alias || found_by_alias)) continue;
    if (const auto [other, is_new] = used.emplace(settings.alias, &slave); !is_new) {
      FindingList findings(out, slave.position);
      findings.add("alias-twice", fig::number<"alias">(settings.alias),
                   fig::slave<"slave">(other->second->position, other->second->settings->name));
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
        findings.add("wiring-impossible");
      } else if (previous->port > 3 || (previous->port == 0 && !swapped)) {
        findings.add("wiring-port");
      }
    }
    if (entries[slave.position].value_or(0) != 0) {
      findings.add("cables-swapped");
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
  check_aliases(out, slaves);
  check_wiring(out, slaves);
  check_sync_units(out, project.master, slaves);
}

}  // namespace syncline::compiler
