// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

struct DeviceDescription;
struct StartupCommand;

/// True for a start-up command as the ESI has it: only those are adapted to the cycle, never the user's own.
[[nodiscard]] bool is_from_esi(const StartupCommand& command, const DeviceDescription& device);

}  // namespace syncline
