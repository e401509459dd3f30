// SPDX-License-Identifier: Apache-2.0
#include "compile/task_plan.h"

#include <algorithm>

#include "compile/cyclic_frames.h"
#include "compile/slave_plan.h"
#include "config/cyclic_frame.h"
#include "config/master_settings.h"
#include "config/project.h"

namespace syncline::compiler {

std::size_t sync_unit_number(const MasterSettings& master, std::string_view name) {
  if (name.empty()) return 0;
  const auto found = std::ranges::find(master.sync_units, name, &SyncUnit::name);
  return found == master.sync_units.end() ? 0 : static_cast<std::size_t>(found - master.sync_units.begin()) + 1;
}

std::vector<std::size_t> unit_tasks(const MasterSettings& master) {
  std::vector<std::size_t> tasks{0};
  for (const SyncUnit& unit : master.sync_units) {
    const auto found = std::ranges::find(master.tasks, unit.task, &TaskSettings::name);
    const bool base = unit.task.empty() || found == master.tasks.end();
    tasks.push_back(base ? 0 : static_cast<std::size_t>(found - master.tasks.begin()) + 1);
  }
  return tasks;
}

Nanoseconds task_cycle(const MasterSettings& master, std::size_t task) {
  constexpr std::uint32_t kLargest = 1000;  // a file may say any number
  const std::uint32_t multiple =
      task == 0 ? 1 : std::clamp<std::uint32_t>(master.tasks[task - 1].multiple, 1, kLargest);
  return master.cycle_time * multiple;
}

Nanoseconds sync_unit_cycle(const MasterSettings& master, const SlaveSettings& slave, bool writes, bool reads) {
  const auto tasks = unit_tasks(master);
  const auto cycle_of = [&](const std::string& unit) {
    return task_cycle(master, tasks[sync_unit_number(master, unit)]);
  };
  if (writes && reads) return std::min(cycle_of(slave.output_unit), cycle_of(slave.input_unit));
  return writes ? cycle_of(slave.output_unit) : reads ? cycle_of(slave.input_unit) : master.cycle_time;
}

void plan_tasks(const Project& project, std::span<SlavePlan> slaves) {
  const MasterSettings& master = project.master;
  for (SlavePlan& slave : slaves) {
    slave.output_unit = sync_unit_number(master, slave.settings->output_unit);
    slave.input_unit = sync_unit_number(master, slave.settings->input_unit);
    slave.cycle_time = sync_unit_cycle(master, *slave.settings, slave.image_bits(PdoDirection::kRx) > 0,
                                       slave.image_bits(PdoDirection::kTx) > 0);
  }
}

std::vector<CyclicTask> cyclic_tasks(const MasterSettings& master, const CyclicLayout& cyclic) {
  std::vector<CyclicTask> tasks;
  const auto add = [&](std::size_t number, const std::vector<CyclicFrame>& frames) {
    CyclicTask& task = tasks.emplace_back();
    task.cycle_time = task_cycle(master, number);
    task.frames = frames;
    if (number > 0) task.comment = master.tasks[number - 1].name;
  };
  add(0, cyclic.frames);
  for (std::size_t i = 0; i < cyclic.slower.size(); ++i) {
    if (!cyclic.slower[i].empty()) add(i + 1, cyclic.slower[i]);
  }
  return tasks;
}

}  // namespace syncline::compiler
