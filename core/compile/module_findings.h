// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compile/finding_list.h"
#include "compile/slave_plan.h"

namespace syncline::compiler {

/// Modules that do not fit, places that must not be empty, operation modes and PDOs that modules demand.
void find_module_problems(FindingList& findings, const SlavePlan& slave);

}  // namespace syncline::compiler
