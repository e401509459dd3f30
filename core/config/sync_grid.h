// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline {

struct NetworkConfig;

/// Grid in which the SYNC signals of all slaves repeat together, ns: the least common multiple of the bus cycle, all
/// SYNC cycles and the user's grid. SYNC0 of a slave lies at the base of the DC grid + n * this + its shift. Nothing
/// where that is more than a minute: then only the bus cycle is common to all, and a SYNC0 that comes with every so
/// many cycles may have begun with any of them.
[[nodiscard]] std::optional<Nanoseconds> sync_grid(const NetworkConfig& config);

}  // namespace syncline
