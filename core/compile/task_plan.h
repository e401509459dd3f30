// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace syncline {
struct CyclicTask;
struct MasterSettings;
struct Project;
}  // namespace syncline

/// Which task exchanges whose process data.
namespace syncline::compiler {

struct CyclicLayout;
struct SlavePlan;

/// Fills SlavePlan::output_unit, input_unit and cycle_time.
void plan_tasks(const Project& project, std::span<SlavePlan> slaves);

/// The base task, then the slower ones that have something to exchange.
[[nodiscard]] std::vector<CyclicTask> cyclic_tasks(const MasterSettings& master, const CyclicLayout& cyclic);

}  // namespace syncline::compiler
