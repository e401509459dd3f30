// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "config/compile/compile.h"
#include "config/compile/slave_plan.h"

namespace syncline::compiler {

/// What is wrong or odd in a project, with the settings key that cures it. Pure; master first, then slaves in order.
[[nodiscard]] std::vector<Finding> find_problems(const Project& project, const std::vector<SlavePlan>& slaves,
                                                 const NetworkConfig& config);

}  // namespace syncline::compiler
