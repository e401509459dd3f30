// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "config/project.h"
#include "protocol/dl_status.h"

namespace syncline {

/// Predecessor and its port for every slave, from the DL status of all slaves in frame order: frames
/// leave a slave by its open ports in the order 3, 1, 2. Empty for the first slave and where the open
/// ports do not explain the position. Pure.
[[nodiscard]] std::vector<std::optional<PreviousPort>> find_topology(std::span<const DlStatus> slaves);

}  // namespace syncline
