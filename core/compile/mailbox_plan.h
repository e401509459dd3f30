// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace syncline {
struct DeviceDescription;
struct MailboxConfig;
}  // namespace syncline

namespace syncline::compiler {

struct MailboxPlan;
struct SlavePlan;

/// The mailbox SyncManagers of a device with their bootstrap variant; empty when it has no complete pair.
[[nodiscard]] std::optional<MailboxPlan> plan_mailbox(const DeviceDescription& device);

/// ENI Slave/Mailbox without the CoE commands. Without status bit the master polls every `poll_time_ms`.
[[nodiscard]] MailboxConfig mailbox_config(const SlavePlan& slave, std::uint32_t poll_time_ms);

}  // namespace syncline::compiler
