// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline::compiler {

struct FmmuPlan;
struct SlavePlan;

/// FMMUs of a slave that has its place in the logical address space: outputs, then inputs (one for each SyncManager
/// with data, or one for neighbours where the ESI lists fewer FMMUs), then the mailbox state. This order is the
/// numbering, whatever order the ESI lists.
[[nodiscard]] std::vector<FmmuPlan> plan_fmmus(const SlavePlan& slave);

}  // namespace syncline::compiler
