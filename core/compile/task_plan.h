// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "support/types.h"

namespace syncline {
struct CyclicTask;
struct MasterSettings;
struct Project;
struct SlaveSettings;
}  // namespace syncline

/// Which task exchanges whose process data.
namespace syncline::compiler {

struct CyclicLayout;
struct SlavePlan;

/// Number of a Sync Unit by its name: 0 for the unnamed one and for names that nobody has.
[[nodiscard]] std::size_t sync_unit_number(const MasterSettings& master, std::string_view name);

/// Task of each Sync Unit, the unnamed one first: 0 is the base task, 1.. those of MasterSettings::tasks. A unit whose
/// task does not exist stays in the base task.
[[nodiscard]] std::vector<std::size_t> unit_tasks(const MasterSettings& master);

/// Cycle of a task, ns.
[[nodiscard]] Nanoseconds task_cycle(const MasterSettings& master, std::size_t task);

/// Sync Unit Cycle of a slave, ns: the shorter one of the tasks that exchange what it `writes` (has as outputs) and
/// `reads`, the bus cycle where it exchanges nothing. The base of the factors of SYNC0 and SYNC1.
[[nodiscard]] Nanoseconds sync_unit_cycle(const MasterSettings& master, const SlaveSettings& slave, bool writes,
                                          bool reads);

/// Fills SlavePlan::output_unit, input_unit and cycle_time.
void plan_tasks(const Project& project, std::span<SlavePlan> slaves);

/// The base task, then the slower ones that have something to exchange.
[[nodiscard]] std::vector<CyclicTask> cyclic_tasks(const MasterSettings& master, const CyclicLayout& cyclic);

}  // namespace syncline::compiler
