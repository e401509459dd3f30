// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
struct NetworkConfig;
struct Project;
}  // namespace syncline

namespace syncline::recover {

/// Register commands of `config` that no setting stands for become the user's own. `compiled` is what `project` makes
/// without them. Where it makes every command of a slave (or of the master) as it is in `config`, all others are its
/// own; where another tool chose other commands, only those to registers that `compiled` does not touch, since the
/// others say the same in another way. Commands that are neither FPRD and FPWR of the slave nor BRD and BWR of the
/// master stay out.
void recover_register_commands(Project& project, const NetworkConfig& config, const NetworkConfig& compiled);

}  // namespace syncline::recover
