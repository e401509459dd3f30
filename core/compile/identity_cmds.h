// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compile/init_cmd_builder.h"
#include "config/identity.h"

namespace syncline {
struct DeviceDescription;
struct SlaveSettings;
}  // namespace syncline

namespace syncline::compiler {

struct SlavePlan;

/// INIT to PREOP: what the master compares before it takes the device for the configured one (IdentityCheck).
void add_identity_check(InitCmdBuilder& cmds, const SlavePlan& slave);

/// Asks the device for its explicit device ID (ETG.1020) and compares: in the register that its ESI names, else by the
/// request bit of AL control and 0x0134.
void add_device_id_check(InitCmdBuilder& cmds, const Transitions& when, const DeviceDescription& device,
                         std::uint16_t id, std::uint32_t timeout_ms);

/// How the revision is compared, from the user's rule or the ESI's.
[[nodiscard]] RevisionCheck revision_rule(const SlaveSettings& slave);

}  // namespace syncline::compiler
