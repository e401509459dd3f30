// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct Finding;
struct NetworkConfig;
struct Project;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// Cycle time, wire load, reference clock, sync window, station addresses.
void find_master_problems(std::vector<Finding>& out, const Project& project, const std::vector<SlavePlan>& slaves,
                          const NetworkConfig& config);

}  // namespace syncline::compiler
