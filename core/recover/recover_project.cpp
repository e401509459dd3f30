// SPDX-License-Identifier: Apache-2.0
#include "recover/recover_project.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/finding_list.h"
#include "recover/recovered_commands.h"
#include "recover/recovered_slave.h"
#include "recover/recovered_tasks.h"

namespace syncline {
namespace {

using compiler::FindingList;

bool same(const StartupCommand& left, const StartupCommand& right) {
  return left.transitions == right.transitions && left.index == right.index && left.sub_index == right.sub_index &&
         left.data == right.data && left.complete_access == right.complete_access && left.enabled == right.enabled;
}

/// Of `wanted` what is not among `generated`, each of which accounts for one.
std::vector<StartupCommand> without(const std::vector<CoeInitCmd>& wanted, std::vector<CoeInitCmd> generated) {
  std::vector<StartupCommand> rest;
  for (const CoeInitCmd& cmd : wanted) {
    const auto found =
        std::ranges::find_if(generated, [&](const CoeInitCmd& g) { return same(g.command, cmd.command); });
    if (found == generated.end()) {
      rest.push_back(cmd.command);
    } else {
      generated.erase(found);
    }
  }
  return rest;
}

/// What no setting stands for: start-up commands of CoE and register commands of the user's own.
void recover_startup(Project& project, const NetworkConfig& config, EniDialect dialect) {
  const auto compiled = compile(project, {dialect});
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    if (!config.slaves[i].mailbox) continue;
    const bool known = compiled && i < compiled->config.slaves.size() && compiled->config.slaves[i].mailbox;
    project.slaves[i].startup =
        without(config.slaves[i].mailbox->coe_commands,
                known ? compiled->config.slaves[i].mailbox->coe_commands : std::vector<CoeInitCmd>{});
  }
  if (compiled) recover::recover_register_commands(project, config, compiled->config);
}

bool uses(const NetworkConfig& config, Command command) {
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      if (std::ranges::any_of(frame.commands, [&](const CyclicCmd& cmd) {
            return cmd.command == command && cmd.logical_address != config.master.mailbox_state_start;
          })) {
        return true;
      }
    }
  }
  return false;
}

void recover_master(Project& project, const NetworkConfig& config, FindingList& findings) {
  MasterSettings& master = project.master;
  master.name = config.master.name;
  master.destination_mac = config.master.destination_mac;
  master.source_mac = config.master.source_mac;
  master.cycle_time = config.cycle_time();
  master.overlap_process_data = uses(config, Command::kLrw) || !uses(config, Command::kLwr);
  master.dc = config.dc;
  master.recovery = config.recovery;
  master.real_time = config.real_time;
  if (config.dc.enabled) {
    findings.add("clock-settings-unknown");
  }
  if (!config.cyclic.empty() && !config.cyclic.front().cycle_time_given) {
    findings.add("cycle-time-unknown", fig::time<"cycle">(config.cycle_time()));
  }
}

void report_copies(const NetworkConfig& config, FindingList& findings) {
  std::size_t copies = 0;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      for (const auto& cmd : frame.commands) copies += cmd.copy_infos.size();
    }
  }
  if (copies > 0) {
    findings.add("copies-lost", fig::count<"copies">(copies));
  }
}

}  // namespace

EniDialect dialect_of(const NetworkConfig& config) {
  return config.image.command_data_offset > 0 ? EniDialect::kTwinCat : EniDialect::kEcEngineer;
}

RecoveredProject recover_project(const NetworkConfig& config, const DeviceLookup& devices) {
  RecoveredProject recovered;
  recovered.dialect = dialect_of(config);
  FindingList of_master(recovered.findings, -1);
  recover_master(recovered.project, config, of_master);
  for (std::size_t i = 0; i < config.slaves.size(); ++i) {
    FindingList findings(recovered.findings, static_cast<int>(i));
    recovered.project.slaves.push_back(recover::recovered_slave(config, i, devices, findings));
  }
  recover::recover_tasks(recovered.project, config, of_master);
  recover_startup(recovered.project, config, recovered.dialect);
  report_copies(config, of_master);
  if (const auto compiled = compile(recovered.project, {recovered.dialect})) {
    recovered.differences = compare_networks(config, compiled->config);
  } else {
    of_master.add("project-not-compiled", fig::reason<"reason">(compiled.error().detail));
  }
  return recovered;
}

}  // namespace syncline
