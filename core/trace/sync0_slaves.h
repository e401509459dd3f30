// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "support/types.h"

namespace syncline {

struct NetworkConfig;

/// What a configuration says of the SYNC0 of a slave and of the way of its outputs. Times in ns.
struct Sync0Slave {
  Nanoseconds period = 0;  // of SYNC0; 0: where outputs come in it is not known (no SYNC0, no outputs of the base task,
                           // or a grid of more than a minute that hides with which cycle SYNC0 comes)
  Nanoseconds shift = 0;   // of SYNC0 against the base of the grid
  Nanoseconds wire = 0;    // see outputs_wire_time()
  int frames = 0;          // that are due in a period; 0: SYNC0 is no multiple of the bus cycle
  bool operator==(const Sync0Slave&) const = default;
};
/// By position.
[[nodiscard]] std::vector<Sync0Slave> sync0_slaves(const NetworkConfig& config);

}  // namespace syncline
