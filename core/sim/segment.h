// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/sim_config.h"
#include "support/types.h"

namespace syncline::sim {

/// The way of a frame through a segment: every reception at a port, with the time since the master sent.
struct Passage {
  std::uint16_t slave = 0;
  std::uint8_t port = 0;      // where the frame is received
  bool processed = false;     // behind this port lies the processing unit
  double time_ns = 0;         // since the frame's start left the master
};

/// State of the cable to a slave's parent and of its power.
struct SlaveLink {
  bool cable = true;
  bool power = true;
};

struct SegmentPath {
  std::vector<Passage> passages;  // in order of time
  double return_ns = 0;           // until the frame's start is back at the master
};

/// Depth first in port order 0-3-1-2 (ESC data sheet I, 3.2): processing delay behind port 0, forwarding
/// delay behind the others, 5 ns a metre of cable. A port without a partner is closed.
[[nodiscard]] SegmentPath segment_path(std::span<const SimSlaveConfig> slaves, std::span<const SlaveLink> links);

}  // namespace syncline::sim
