// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct StartupCommand;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// Downloads on PS that the settings slave.N.sync.*, slave.N.can.* and slave.N.output_pin.* ask for. Without SYNC0 a
/// gateway with a CAN cycle is told its bus cycle, unless the start-up list does so.
[[nodiscard]] std::vector<StartupCommand> sync_commands(const SlavePlan& slave);

}  // namespace syncline::compiler
