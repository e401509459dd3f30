// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::compiler {

class FindingList;
struct SlavePlan;

/// Modules that do not fit, places that must not be empty, operation modes and PDOs that modules demand.
void find_module_problems(FindingList& findings, const SlavePlan& slave);

}  // namespace syncline::compiler
