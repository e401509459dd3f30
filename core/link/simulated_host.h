// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline {

struct SimConfig;
struct SimulatedHost;
class VirtualClock;

/// Gives the clock the wake-ups and standstills of the scenario's host, counted from its present time, which is when
/// the bus is switched on. Returns how that host sends and stamps.
[[nodiscard]] SimulatedHost set_up_host(VirtualClock& clock, const SimConfig& config);

/// Its standstills alone.
void add_standstills(VirtualClock& clock, const SimConfig& config);

}  // namespace syncline
