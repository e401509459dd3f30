// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::compiler {

class InitCmdBuilder;
struct SlavePlan;

/// PREOP to SAFEOP: SYNC cycle times, start time and activation; clears on the way into PREOP. Nothing for a slave
/// without DC commands. The start time written is the SYNC0 shift: the master adds the common start when it runs.
void add_dc_start(InitCmdBuilder& cmds, const SlavePlan& slave);
/// Back to PREOP: SYNC signals off.
void add_dc_stop(InitCmdBuilder& cmds, const SlavePlan& slave);

}  // namespace syncline::compiler
