// SPDX-License-Identifier: Apache-2.0
#include "config/sync_unit_cycle.h"

#include <algorithm>

#include "config/master_settings.h"
#include "config/module_slots.h"
#include "config/slave_settings.h"

namespace syncline::compiler {
namespace {

/// Whether a PDO is assigned that has bits, with the entries that the user gave it.
bool exchanges(const SlaveSettings& slave, PdoDirection direction) {
  return std::ranges::any_of(slave.assigned_pdos(direction), [&slave](std::uint16_t index) {
    const auto pdo = pdo_of(slave, index);
    return pdo && effective_pdo(slave, *pdo).bit_length() > 0;
  });
}

}  // namespace

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

Nanoseconds sync_unit_cycle(const MasterSettings& master, const SlaveSettings& slave) {
  const auto tasks = unit_tasks(master);
  const auto out = task_cycle(master, tasks[sync_unit_number(master, slave.output_unit)]);
  const auto in = task_cycle(master, tasks[sync_unit_number(master, slave.input_unit)]);
  if (out == in && out == master.cycle_time) return out;
  const bool writes = exchanges(slave, PdoDirection::kRx), reads = exchanges(slave, PdoDirection::kTx);
  if (writes && reads) return std::min(out, in);
  return writes ? out : reads ? in : master.cycle_time;
}

}  // namespace syncline::compiler
