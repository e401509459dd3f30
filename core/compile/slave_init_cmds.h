// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compile/compile.h"

namespace syncline::compiler {

struct SlavePlan;

/// The register commands of one slave for every transition, in the order that ET9000, TwinCAT 3 and EC-Engineer share
/// (docs/eni.md lists it row by row). A master runs those of a transition in list order.
[[nodiscard]] std::vector<InitCmd> slave_init_cmds(const SlavePlan& slave, EniDialect dialect);

}  // namespace syncline::compiler
