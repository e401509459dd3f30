// SPDX-License-Identifier: Apache-2.0
#include "compile/task_plan.h"

#include "compile/cyclic_frames.h"
#include "compile/slave_plan.h"
#include "config/cyclic_frame.h"
#include "config/master_settings.h"
#include "config/project.h"
#include "config/sync_unit_cycle.h"

namespace syncline::compiler {

void plan_tasks(const Project& project, std::span<SlavePlan> slaves) {
  const MasterSettings& master = project.master;
  for (SlavePlan& slave : slaves) {
    slave.output_unit = sync_unit_number(master, slave.settings->output_unit);
    slave.input_unit = sync_unit_number(master, slave.settings->input_unit);
    slave.cycle_time = sync_unit_cycle(master, *slave.settings);
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
