// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compile/compile.h"
#include "compile/slave_plan.h"

namespace syncline::compiler {

/// Cycle time, wire load, reference clock, sync window, station addresses.
void find_master_problems(std::vector<Finding>& out, const Project& project, const std::vector<SlavePlan>& slaves,
                          const NetworkConfig& config);

}  // namespace syncline::compiler
