// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "channels/values/bus_scan.h"
#include "dc/propagation_delay.h"
#include "master/scan/topology.h"
#include "protocol/dl_status.h"

namespace syncline {

class Bus;
class SlaveAddress;

/// What the slaves of a segment can do with clocks, and their ports. Frame order.
struct ClockSegment {
  std::vector<DcCapability> capabilities;
  std::vector<DlStatus> dl_status;
  /// Ready to be filled with receive times; the wiring is found with them.
  std::vector<dc::DelayNode> nodes;
  bool whole = false;               // nobody else answers on the bus
  std::vector<SlaveWiring> wiring;  // once there are receive times
};
/// Reads only. kNoResponse names the slave that does not answer.
[[nodiscard]] Result<ClockSegment> read_clock_segment(Bus& bus, std::span<const SlaveAddress> slaves);

[[nodiscard]] bool has_system_time(DcCapability capability);

/// Wired as ports and receive times say. Takes milliseconds for hundreds of slaves of which a port leads elsewhere.
/// Pure.
[[nodiscard]] std::vector<SlaveWiring> segment_wiring(std::span<const dc::DelayNode> nodes,
                                                      std::span<const DlStatus> dl_status);

/// The delays of slaves in the order in which frames pass their processing units. That order is not the tree's when a
/// slave is connected by another port than 0: what hangs at it may come before it. `whole`: they are all that there
/// are, and whatever comes in at a port with nobody behind it is none of the master's frame, when ever it comes. Pure.
[[nodiscard]] dc::DelayResult segment_delays(std::span<const dc::DelayNode> nodes, std::span<const SlaveWiring> wiring,
                                             bool whole, const dc::DelayOptions& options);

/// Whether a finding of those delays says anything where this slave leads: all behind it are measured from it, however
/// frames come to it.
[[nodiscard]] bool matters_behind(std::size_t leader, const dc::DelayFinding& finding);

}  // namespace syncline
