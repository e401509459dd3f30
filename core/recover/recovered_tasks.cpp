// SPDX-License-Identifier: Apache-2.0
#include "recover/recovered_tasks.h"

#include <fmt/format.h>

#include <algorithm>

#include "compile/finding_list.h"
#include "config/cyclic_frame.h"
#include "config/network_config.h"
#include "config/project.h"
#include "recover/register_writes.h"

namespace syncline::recover {
namespace {

constexpr Nanoseconds kMostCycles = 1000;

/// Whether one of the task's commands carries this logical address, reading or writing.
bool exchanges(const CyclicTask& task, std::uint32_t address, bool writing) {
  for (const auto& frame : task.frames) {
    for (const auto& cmd : frame.commands) {
      const bool fits = cmd.command == Command::kLrw || cmd.command == (writing ? Command::kLwr : Command::kLrd);
      if (fits && address >= cmd.logical_address && address - cmd.logical_address < cmd.length()) return true;
    }
  }
  return false;
}

void assign(Project& project, const NetworkConfig& config, const CyclicTask& task, const std::string& unit) {
  for (std::size_t i = 0; i < project.slaves.size(); ++i) {
    for (const auto& [number, fmmu] : register_writes(config.slaves[i].init_cmds).fmmus) {
      if (!fmmu.active || !exchanges(task, fmmu.logical_start, fmmu.write)) continue;
      (fmmu.write ? project.slaves[i].output_unit : project.slaves[i].input_unit) = unit;
    }
  }
}

std::string name_of(const CyclicTask& task, std::size_t number, const std::vector<TaskSettings>& tasks) {
  const bool taken = std::ranges::count(tasks, task.comment, &TaskSettings::name) > 0;
  return task.comment.empty() || taken ? fmt::format("Task {}", number + 1) : task.comment;
}

}  // namespace

void recover_tasks(Project& project, const NetworkConfig& config, compiler::FindingList& findings) {
  const Nanoseconds base = config.cycle_time();
  for (std::size_t t = 1; t < config.cyclic.size(); ++t) {
    const CyclicTask& task = config.cyclic[t];
    const Nanoseconds multiple = base > 0 ? task.cycle_time / base : 0;
    if (multiple < 1 || multiple > kMostCycles || multiple * base != task.cycle_time) {
      findings.add("task-not-recovered", fig::number<"task">(t + 1), fig::time<"cycle">(task.cycle_time),
                   fig::time<"first">(base));
      continue;
    }
    const auto name = name_of(task, t, project.master.tasks);
    if (multiple > 1) project.master.tasks.push_back({name, static_cast<std::uint32_t>(multiple)});
    project.master.sync_units.push_back({name, multiple > 1 ? name : std::string()});
    assign(project, config, task, name);
  }
}

}  // namespace syncline::recover
