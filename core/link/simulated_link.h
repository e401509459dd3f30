// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "link/link.h"
#include "sim/sim_bus.h"
#include "support/clock.h"

namespace syncline {

/// How the simulated host sends.
struct SimulatedHost {
  /// Scale of the one-sided normal time from the moment that software calls the moment of sending until the frame is on
  /// the wire, ns. What software knows of its send times is wrong by it.
  double send_delay_ns = 0;
  std::uint64_t seed = 1;
  /// A sixth of the wake-up's scale.
  [[nodiscard]] static SimulatedHost with(const JitterProfile& jitter, std::uint64_t seed) { return {jitter.sigma_ns / 6, seed}; }
};

/// The simulated segment as a Link. On a virtual clock receive() moves time to the frame's arrival or
/// to the deadline; on the real clock it sleeps.
[[nodiscard]] std::unique_ptr<Link> make_simulated_link(std::string name, std::unique_ptr<sim::SimBus> bus, Clock& clock,
                                                        const SimulatedHost& host = {});

}  // namespace syncline
