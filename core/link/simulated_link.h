// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "link/link.h"
#include "sim/sim_bus.h"
#include "support/clock.h"

namespace syncline {

/// The simulated segment as a Link. On a virtual clock receive() moves time to the frame's arrival or
/// to the deadline; on the real clock it sleeps.
[[nodiscard]] std::unique_ptr<Link> make_simulated_link(std::string name, std::unique_ptr<sim::SimBus> bus, Clock& clock);

}  // namespace syncline
