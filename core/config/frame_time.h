// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "support/types.h"

/// How long a bus cycle's frames are under way.
namespace syncline {

struct CyclicFrame;
struct NetworkConfig;

/// From the Ethernet header to the last datagram; neither padding nor FCS.
[[nodiscard]] std::size_t frame_bytes(const CyclicFrame& frame);
/// With both.
[[nodiscard]] std::size_t bytes_sent(const CyclicFrame& frame);

/// Time on a 100 Mbit/s wire of one frame with these commands: preamble, header, padding, FCS and gap included.
[[nodiscard]] Nanoseconds wire_time(const CyclicFrame& frame);

/// There and back through one slave before anybody has measured it: two PHYs, processing unit and forwarding of an ESC
/// take 0.6 to 1.2 us at MII ports and about 0.3 us at E-bus (ESC data sheet I, 9.1.2 and the PHYs' own data sheets).
/// `physics`: of its ports, "YY" or "KK" (ETG.2000); nothing where an ENI does not say.
[[nodiscard]] constexpr Nanoseconds travel_through(std::string_view physics) {
  return physics.starts_with('K') || physics.starts_with('B') ? 300 : kMicrosecond;
}
/// Of a frame through all slaves and back; an estimate.
[[nodiscard]] Nanoseconds travel_time(const NetworkConfig& config);

/// When the frames of a cycle must be back, from its begin; what comes later counts as lost or late.
[[nodiscard]] constexpr Nanoseconds latest_return(Nanoseconds cycle_time) { return cycle_time * 95 / 100; }

/// From when a cycle's first frame reaches a slave until the one with its outputs has passed it: what an ESC is sent is
/// valid, and SM2's event comes, at the end of the frame (ESC data sheet I, 5.2). With a slower task those in front of
/// it are thought to go with the same cycle. 0 for a slave without outputs.
[[nodiscard]] Nanoseconds outputs_wire_time(const NetworkConfig& config, std::size_t slave);

struct CycleNeed {
  Nanoseconds wire = 0;    // of all frames, one behind the other
  Nanoseconds travel = 0;  // through all slaves; an estimate
  [[nodiscard]] Nanoseconds all() const { return wire + travel; }
};
/// Of a cycle in which only the base task is due, or all tasks.
[[nodiscard]] CycleNeed cycle_need(const NetworkConfig& config, bool all_tasks = false);

}  // namespace syncline
