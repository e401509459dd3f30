// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config/pdo_description.h"

namespace syncline {

struct SlaveSettings;

/// Number of the SyncManager that exchanges a PDO when it is assigned: the one that the ESI names for it (Pdo@Sm) where
/// that is of its direction, else the first one of its direction; empty where the device has none.
[[nodiscard]] std::optional<std::uint8_t> sync_manager_of(const SlaveSettings& slave, PdoDirection direction,
                                                          const Pdo& pdo);

}  // namespace syncline
