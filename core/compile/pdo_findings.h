// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::compiler {

class FindingList;
struct SlavePlan;

/// Assignments that the ESI forbids or that do not fit the SyncManagers, and changed mappings that cannot be written.
void find_pdo_problems(FindingList& findings, const SlavePlan& slave);

}  // namespace syncline::compiler
