// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/mailbox.h"

namespace syncline {

struct DeviceDescription;
struct MailboxInitCmd;
struct SoeCommand;
struct StartupCommand;

/// True for a start-up command as the ESI has it: only those are adapted to the cycle, never the user's own.
[[nodiscard]] bool is_from_esi(const StartupCommand& command, const DeviceDescription& device);
[[nodiscard]] bool is_from_esi(const SoeCommand& command, const DeviceDescription& device);
/// `type`: the protocol in whose list it is.
[[nodiscard]] bool is_from_esi(const MailboxInitCmd& message, const DeviceDescription& device, MailboxType type);

}  // namespace syncline
