// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "support/random.h"
#include "tests/support/simulated_network.h"

namespace syncline::test {

/// A drive of which only controlword and statusword are exchanged, so that a thousand fit into a millisecond of wire
/// time.
inline DeviceDescription small_servo() {
  auto device = servo();
  const auto keep = [](std::vector<Pdo>& pdos, std::initializer_list<std::uint16_t> indices) {
    for (auto& pdo : pdos) {
      std::erase_if(pdo.entries,
                    [&](const auto& entry) { return std::ranges::find(indices, entry.index) == indices.end(); });
    }
  };
  keep(device.rx_pdos, {0x6040});
  keep(device.tx_pdos, {0x6041});
  return device;
}

/// A coupler-like terminal and two servo axes.
inline void add_two_axes(SimulatedNetwork& network) {
  network.add(io8());
  network.add(servo(), "servo-y");
  network.add(servo(), "servo-y");
}

/// The same in bus shift with the sync window watched: servos with polled mailboxes and counters of missed events.
inline SimulatedNetwork two_axes() {
  SimulatedNetwork network;
  add_two_axes(network);
  network.project.master.dc.sync_window.enabled = true;
  network.project.master.dc.dcm.mode = DcmMode::kBusShift;
  return network;
}

/// Quartzes of +-45 ppm, clocks that were switched on at different times, cables of different lengths.
inline void give_random_clocks(SimulatedNetwork& network, Random& random) {
  for (auto& slave : network.sim.slaves) {
    slave.oscillator.ppm = random.uniform(-45, 45);
    slave.oscillator.start_offset = static_cast<Nanoseconds>(random.uniform(0, 4e9));
    slave.cable_m = random.uniform(0.5, 60);
  }
}

}  // namespace syncline::test
