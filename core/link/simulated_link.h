// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "link/adapter_faults.h"
#include "support/jitter_profile.h"
#include "support/types.h"

namespace syncline::sim {
class SimBus;
}  // namespace syncline::sim

namespace syncline {

class Clock;
class Link;

/// How the simulated host sends, and stamps what comes.
struct SimulatedHost {
  /// Its calendar clock, of which the stamps of frames are, is set.
  struct CalendarStep {
    Nanoseconds at = 0;  // on the link's clock
    Nanoseconds by = 0;  // forwards
  };

  /// From the moment that software takes for that of sending until the frame leaves: what the host knows of its send
  /// times is wrong by it. That long it is busy with sending.
  QuantileCurve stamp_error{};
  std::uint64_t seed = 1;
  std::vector<CalendarStep> calendar_steps{};
  AdapterFaults adapter{};
  [[nodiscard]] static SimulatedHost with(const JitterProfile& jitter, std::uint64_t seed) {
    return {jitter.stamp_error, seed, {}, {}};
  }
};

/// The simulated segment as a Link. On a virtual clock receive() moves time to the frame's arrival or
/// to the deadline; on the real clock it sleeps.
[[nodiscard]] std::unique_ptr<Link> make_simulated_link(std::string name, std::unique_ptr<sim::SimBus> bus,
                                                        Clock& clock, const SimulatedHost& host = {});

}  // namespace syncline
