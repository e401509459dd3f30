// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {
struct MailboxConfig;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// Adds the start-up messages of AoE, EoE, FoE, SoE and VoE: those of the project and those that its settings make.
void add_mailbox_init_cmds(MailboxConfig& mailbox, const SlavePlan& slave);

}  // namespace syncline::compiler
