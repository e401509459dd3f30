// SPDX-License-Identifier: Apache-2.0
#include "bench/soak_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "config/dcm_settings.h"
#include "support/jitter_profile.h"
#include "tests/support/machine_devices.h"
#include "tests/support/own_devices.h"

namespace syncline::bench {
namespace {

std::vector<std::size_t> clocks_of(const test::SimulatedNetwork& network) {
  std::vector<std::size_t> clocks;
  for (std::size_t i = 0; i < network.sim.slaves.size(); ++i) {
    if (network.sim.slaves[i].dc.system_time) clocks.push_back(i);
  }
  return clocks;
}

void add_any(test::SimulatedNetwork& network, Random& random) {
  constexpr std::array kKinds{0, 0, 0, 1, 1, 2, 3};
  switch (kKinds[random.next() % kKinds.size()]) {
    case 1:
      network.add(test::servo(), "servo-y");
      break;
    case 2:
      network.add(sample::own("SL-XE2"), "drive-c");
      break;
    case 3:
      network.add(sample::own("SL-6751"), "can-gateway");
      break;
    default:
      network.add(random.next() % 8 == 0 ? test::large_io() : test::io8());
  }
  auto& slave = network.sim.slaves.back();
  slave.asymmetry_ns = random.uniform(-20, 20);
  slave.dc.latch_noise_ns = random.uniform(0, 12);
  slave.oscillator.wander_ppm = random.uniform(0, 0.05);
  slave.dc.is_64bit = random.next() % 3 > 0;
  constexpr std::array kEscs{kCableDelays, kEbusDelays, EscDelays{320, 280}, EscDelays{150, 130}, EscDelays{390, 330}};
  if (random.next() % 2 == 0) slave.delays = kEscs[random.next() % kEscs.size()];
  if (random.next() % 4 > 0) return;
  slave.dc.system_time = false;
  slave.dc.receive_times = random.next() % 2 == 0;
  network.project.slaves.back().dc.op_mode.clear();
}

/// A frame leaves a slave by D, B, C in this order.
void add_slaves(test::SimulatedNetwork& network, Random& random) {
  constexpr std::array<std::uint8_t, 3> kOrder{3, 1, 2};
  struct Place {
    std::uint16_t slave;
    std::size_t next;  // of kOrder
  };
  std::vector<Place> way;  // from the first slave to the last one
  const auto count = 3 + random.next() % 20;
  for (std::uint16_t i = 0; i < count; ++i) {
    add_any(network, random);
    if (i > 0) {
      auto depth = way.size() - 1;
      for (auto back = depth; back > 0 && random.next() % 4 == 0; --back) {
        if (way[back - 1].next < kOrder.size()) depth = back - 1;
      }
      way.resize(depth + 1);
      auto& at = way.back();
      const auto which = at.next < 2 && random.next() % 3 > 0 ? 1 : at.next + random.next() % (kOrder.size() - at.next);
      at.next = which + 1;
      network.sim.slaves.back().parent = at.slave;
      network.sim.slaves.back().parent_port = kOrder[which];
      network.project.slaves.back().previous = PreviousPort{at.slave, kOrder[which]};
    }
    way.push_back({i, 0});
  }
}

/// Not the last clock: faults are told by those who follow.
std::size_t draw_leader(test::SimulatedNetwork& network, Random& random) {
  auto able = clocks_of(network);
  able.pop_back();
  if (random.next() % 2 == 0) return able.front();
  const auto leader = able[random.next() % able.size()];
  if (leader != able.front()) network.project.master.dc.reference_clock = static_cast<std::uint16_t>(leader);
  return leader;
}

void draw_master(SoakMachine& machine, Random& random) {
  auto& network = machine.network;
  auto& master = network.project.master;
  constexpr std::array kCycles{kMillisecond / 4, kMillisecond / 2, kMillisecond, 2 * kMillisecond, 4 * kMillisecond};
  master.cycle_time = kCycles[random.next() % kCycles.size()];
  // Its fieldbus has no more room.
  const bool gateway =
      std::ranges::any_of(network.sim.slaves, [](const auto& slave) { return slave.behaviour == "can-gateway"; });
  if (gateway) master.cycle_time = std::max(master.cycle_time, kMillisecond / 2);
  const std::array hosts{network.sim.host_jitter, JitterProfile::quiet(), JitterProfile::desktop()};
  // A drive that needs 60 us for its outputs has hardly that in a quarter of a millisecond.
  if (master.cycle_time < kMillisecond / 2) network.sim.host_jitter = {};
  // A desktop's tails are told at a millisecond, and rightly.
  if (master.cycle_time >= kMillisecond)
    network.sim.host_jitter = hosts[random.next() % (master.cycle_time > kMillisecond ? 3 : 2)];
  const bool desktop = network.sim.host_jitter == JitterProfile::desktop();
  master.dc.sync_window.exponent = static_cast<std::uint8_t>(7 + random.next() % 3);
  master.dc.continuous_propagation_compensation = random.next() % 3 == 0;
  if (random.next() % 3 == 0 && master.cycle_time >= kMillisecond) master.dc.dcm.set_value = master.cycle_time / 2;
  constexpr std::array kModes{DcmMode::kBusShift, DcmMode::kMasterShift, DcmMode::kLinkLayerRefClock,
                              DcmMode::kMasterRefClock};
  for (auto& mode : machine.modes) {
    mode = kModes[random.next() % kModes.size()];
    // A desktop's host shakes a clock that is told its time as it is, which is told, and rightly.
    if (mode == DcmMode::kMasterRefClock && desktop) mode = DcmMode::kMasterShift;
  }
}

void draw_factors(test::SimulatedNetwork& network, Random& random) {
  constexpr Nanoseconds kLongest = 4 * kMillisecond;  // SYNC0 cycle of the servos
  if (2 * network.project.master.cycle_time > kLongest) return;
  for (auto& slave : network.project.slaves) {
    if (!slave.dc.op_mode.empty() && random.next() % 6 == 0) slave.dc.sync0.cycle_factor = 2;
  }
}

/// One slave, and who is behind it, may be unplugged.
void draw_group(test::SimulatedNetwork& network, std::size_t leader, Random& random) {
  constexpr std::uint16_t kAlias = 1000;
  const auto first = leader + 1 + random.next() % network.sim.slaves.size();
  if (first >= network.sim.slaves.size()) return;
  network.project.slaves[first].hot_connect = "branch";
  network.project.slaves[first].alias = network.sim.slaves[first].alias = kAlias;
}

}  // namespace

void draw_whole_tree(SoakMachine& machine, Random& random) {
  auto& network = machine.network;
  do {
    network.sim.slaves.clear();
    network.project.slaves.clear();
    add_slaves(network, random);
  } while (clocks_of(network).size() < 2);
  draw_master(machine, random);
  draw_factors(network, random);
  machine.reference = draw_leader(network, random);
  draw_group(network, machine.reference, random);
}

std::string tree_text(const test::SimulatedNetwork& network) {
  std::string text;
  for (std::size_t i = 0; i < network.sim.slaves.size(); ++i) {
    const auto& slave = network.sim.slaves[i];
    text += fmt::format("{} {} {}{}", i == 0 ? ';' : ',', i, slave.behaviour,
                        !slave.dc.system_time ? (slave.dc.receive_times ? " (times)" : " (no clock)")
                        : slave.dc.is_64bit   ? ""
                                              : " (32 bit)");
    if (slave.parent) text += fmt::format(" at {}{}", *slave.parent, "ABCD"[slave.parent_port]);
    if (!network.project.slaves[i].hot_connect.empty()) text += " may be unplugged";
  }
  return text;
}

}  // namespace syncline::bench
