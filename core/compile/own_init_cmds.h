// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace syncline {
struct InitCmd;
struct RegisterCommand;
}  // namespace syncline

namespace syncline::compiler {

/// Register commands of the user's own for the slave at `station`, those that are on, in their order; one slave
/// answers.
[[nodiscard]] std::vector<InitCmd> own_slave_cmds(const std::vector<RegisterCommand>& commands, std::uint16_t station);
/// The same of the master, to all slaves.
[[nodiscard]] std::vector<InitCmd> own_master_cmds(const std::vector<RegisterCommand>& commands);

}  // namespace syncline::compiler
