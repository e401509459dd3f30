// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "support/types.h"

namespace syncline {
struct MasterSettings;
struct SlaveSettings;
}  // namespace syncline

/// Which task exchanges whose process data, and how often.
namespace syncline::compiler {

/// Number of a Sync Unit by its name: 0 for the unnamed one and for names that nobody has.
[[nodiscard]] std::size_t sync_unit_number(const MasterSettings& master, std::string_view name);

/// Task of each Sync Unit, the unnamed one first: 0 is the base task, 1.. those of MasterSettings::tasks. A unit whose
/// task does not exist stays in the base task.
[[nodiscard]] std::vector<std::size_t> unit_tasks(const MasterSettings& master);

/// Cycle of a task, ns.
[[nodiscard]] Nanoseconds task_cycle(const MasterSettings& master, std::size_t task);

/// Sync Unit Cycle of a slave, ns: that of the faster task which exchanges its assigned outputs or inputs, the bus
/// cycle where none are assigned. The base of the factors of SYNC0 and SYNC1.
[[nodiscard]] Nanoseconds sync_unit_cycle(const MasterSettings& master, const SlaveSettings& slave);

}  // namespace syncline::compiler
