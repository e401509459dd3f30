// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct InitCmd;
}  // namespace syncline

namespace syncline::compiler {

/// The twelve broadcasts that bring a segment of unknown history to a known state, before any slave's own commands.
[[nodiscard]] std::vector<InitCmd> master_init_cmds();

}  // namespace syncline::compiler
