// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compile/slave_plan.h"

namespace syncline::compiler {

/// Adds the start-up messages of EoE, SoE and AoE: those of the ESI and those that the user's settings make.
void add_mailbox_init_cmds(MailboxConfig& mailbox, const SlavePlan& slave);

}  // namespace syncline::compiler
