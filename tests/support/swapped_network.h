// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/random.h"
#include "tests/support/simulated_network.h"
#include "tests/support/swapped_tree.h"

namespace syncline::test {

/// A swapped tree of terminals, with cables of 0.2 to 100 m, quartzes of +-50 ppm and clocks that wrap soon.
inline SimulatedNetwork swapped_network(std::size_t size, std::uint64_t seed) {
  SimulatedNetwork network;
  Random random(seed + 1);
  for (const auto& place : swapped_tree(size, seed)) {
    network.add(io8());
    auto& slave = network.sim.slaves.back();
    slave.cable_m = random.uniform(0.2, 100);
    slave.oscillator.ppm = random.uniform(-50, 50);
    slave.oscillator.start_offset = static_cast<Nanoseconds>(random.uniform() * 8.6e9);
    slave.entry_port = place.entry;
    slave.parent.reset();
    network.project.slaves.back().previous = place.previous;
    if (!place.previous) continue;
    slave.parent = place.previous->position;
    slave.parent_port = place.previous->port;
  }
  return network;
}

}  // namespace syncline::test
