// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "protocol/mailbox.h"
#include "ui/pages/command_parts.h"

namespace syncline::ui {

/// The parts of a start-up message of AoE, EoE, FoE or VoE ("slave.N.aoe.startup.K").
[[nodiscard]] std::vector<RecordPart> messageParts(MailboxType protocol, const ShownDevice& device);

/// The parts of a register command, of a slave ("slave.N.register.K") or of the master ("master.register.K").
[[nodiscard]] std::vector<RecordPart> registerParts(bool of_master);

}  // namespace syncline::ui
