// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/sim_config.h"
#include "link/simulated_link.h"
#include "support/clock.h"

namespace syncline {

/// Gives the clock the wake-ups and standstills of the scenario's host, counted from its present time, which is when
/// the bus is switched on. Returns how that host sends and stamps.
[[nodiscard]] SimulatedHost set_up_host(VirtualClock& clock, const SimConfig& config);

/// Its standstills alone.
void add_standstills(VirtualClock& clock, const SimConfig& config);

}  // namespace syncline
