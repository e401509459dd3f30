// SPDX-License-Identifier: Apache-2.0
#include "bench/soak_machine.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/soak_tree.h"
#include "config/dcm_settings.h"
#include "support/jitter_profile.h"
#include "tests/support/machine_devices.h"
#include "tests/support/own_devices.h"

namespace syncline::bench {
namespace {

constexpr std::size_t kLine = 6;  // slaves that every line has
constexpr std::array kBehaviours{"generic", "servo-y", "servo-y", "drive-c", "can-gateway", "generic"};
constexpr std::uint16_t kGroupAlias = 1000;

void add_line(test::SimulatedNetwork& network) {
  network.add(test::io8());
  network.add(test::servo(), "servo-y");
  network.add(test::servo(), "servo-y");
  network.add(sample::own("SL-XE2"), "drive-c");
  network.add(sample::own("SL-6751"), "can-gateway");
  network.add(test::io8());
}

/// Not at the last one of the line: where a ring is closed there, nothing but the times of its frames, which may come
/// at any, tells it from the branch.
void add_branch(test::SimulatedNetwork& network, Random& random) {
  const std::size_t root = random.next() % 2 == 0 ? 0 : 3;
  const auto count = random.next() % 13;
  for (std::uint64_t i = 0; i < count; ++i) {
    switch (random.next() % 5) {
      case 0:
        network.add(test::servo(), "servo-y");
        break;
      case 1:
        network.add(sample::own("SL-XE2"), "drive-c");
        break;
      case 2:
        network.add(sample::own("SL-6751"), "can-gateway");
        break;
      case 3:
        network.add(random.next() % 2 == 0 ? test::large_io() : test::io8());  // two of them need two frames
        break;
      default:
        network.add(test::io8());
    }
    if (i > 0) continue;
    network.sim.slaves.back().parent = static_cast<std::uint16_t>(root);
    network.sim.slaves.back().parent_port = 2;
    network.project.slaves.back().previous = PreviousPort{static_cast<std::uint16_t>(root), 2};
  }
}

/// At the end of all, to a network whose clock goes at a rate of its own: true where there is one.
bool add_bridge(test::SimulatedNetwork& network, Random& random) {
  if (random.next() % 4 > 0) return false;
  const auto ppm = random.uniform(-20, 20);
  network.add(test::bridge(), "sync-bridge");
  network.sim.slaves.back().external_time = [ppm](Nanoseconds time) {
    const auto passed = static_cast<double>(time - VirtualClock::kDefaultStart);
    return std::optional(time + static_cast<Nanoseconds>(passed * ppm * 1e-6));
  };
  return true;
}

void draw_master(test::SimulatedNetwork& network, Random& random) {
  const std::array hosts{network.sim.host_jitter, JitterProfile::quiet(), JitterProfile::desktop()};
  network.sim.host_jitter = hosts[random.next() % hosts.size()];
  auto& master = network.project.master;
  constexpr std::array kCycles{kMillisecond / 2, kMillisecond, kMillisecond, 2 * kMillisecond, 2 * kMillisecond};
  master.cycle_time = kCycles[random.next() % kCycles.size()];
  // Half a millisecond leaves less than a late wake-up and a stamp that is far off take together, once in hours.
  if (master.cycle_time < kMillisecond) network.sim.host_jitter = hosts.front();
  master.dc.sync_window.exponent = static_cast<std::uint8_t>(7 + random.next() % 3);
  master.dc.continuous_propagation_compensation = random.next() % 3 == 0;
  // Half of a millisecond is too little for a desktop's tails, which is told, and rightly.
  const bool tight = master.cycle_time == kMillisecond && network.sim.host_jitter == JitterProfile::desktop();
  if (random.next() % 3 == 0 && !tight) master.dc.dcm.set_value = master.cycle_time / 2;
}

void draw_slaves(test::SimulatedNetwork& network, Random& random) {
  for (std::size_t i = 0; i < network.sim.slaves.size(); ++i) {
    auto& slave = network.sim.slaves[i];
    slave.asymmetry_ns = random.uniform(-20, 20);
    slave.dc.latch_noise_ns = random.uniform(0, 12);
    slave.oscillator.wander_ppm = random.uniform(0, 0.05);
    slave.dc.is_64bit = i == 0 || random.next() % 3 > 0 || slave.behaviour == "sync-bridge";
    if (slave.behaviour == "sync-bridge") continue;
    if (i >= kLine && random.next() % 4 == 0) network.project.slaves[i].dc.sync0.cycle_factor = 2;
    if (i < kLine - 1 || random.next() % 3 > 0) continue;
    slave.dc.system_time = slave.behaviour != "generic";
    network.project.slaves[i].dc.op_mode.clear();
  }
}

/// The first servo leads, behind a terminal that has no clock, or one that is not led.
std::size_t draw_reference(test::SimulatedNetwork& network, Random& random) {
  switch (random.next() % 4) {
    case 0:
      network.sim.slaves[0].dc.system_time = false;
      network.project.slaves[0].dc.op_mode.clear();
      break;
    case 1:
      network.project.master.dc.reference_clock = 1;
      break;
    default:
      return 0;
  }
  network.sim.slaves[1].dc.is_64bit = true;
  return 1;
}

/// Terminals of the branch that run by themselves are exchanged less often than the drives, and one of these with them.
void draw_task(test::SimulatedNetwork& network, Random& random) {
  if (random.next() % 3 > 0) return;
  auto& project = network.project;
  const auto multiple = 2 + static_cast<std::int32_t>(random.next() % 3);
  project.master.tasks.push_back({.name = "slow", .multiple = static_cast<std::uint32_t>(multiple)});
  project.master.sync_units.push_back({.name = "slow", .task = "slow"});
  constexpr Nanoseconds kLongest = 4 * kMillisecond;  // SYNC0 cycle of the servos
  if (random.next() % 2 == 0 && multiple * project.master.cycle_time <= kLongest) {
    project.slaves[2].output_unit = project.slaves[2].input_unit = "slow";
  }
  for (std::size_t i = kLine; i < project.slaves.size(); ++i) {
    auto& slave = project.slaves[i];
    if (slave.dc.op_mode.empty() && network.sim.slaves[i].behaviour == "generic")
      slave.output_unit = slave.input_unit = "slow";
  }
}

/// The branch may be unplugged.
void draw_group(test::SimulatedNetwork& network, Random& random) {
  if (random.next() % 3 > 0 || network.sim.slaves.size() <= kLine) return;
  auto& slave = network.project.slaves[kLine];
  slave.hot_connect = "branch";
  slave.alias = kGroupAlias;
  network.sim.slaves[kLine].alias = kGroupAlias;
}

void draw_modes(SoakMachine& machine, bool bridge, Random& random) {
  constexpr std::array kBeside{DcmMode::kMasterShift, DcmMode::kLinkLayerRefClock, DcmMode::kMasterRefClock};
  // The way to the external clock takes slaves a little further from it the longer their cycles are.
  auto& master = machine.network.project.master;
  if (bridge && master.cycle_time > kMillisecond)
    master.dc.sync_window.exponent = std::max<std::uint8_t>(master.dc.sync_window.exponent, 9);
  machine.modes[1] = bridge ? DcmMode::kDcx : kBeside[random.next() % kBeside.size()];
  // A desktop's tails shake a clock that is told the nominal time, which is told, and rightly.
  const auto& network = machine.network;
  const bool calm =
      network.sim.host_jitter != JitterProfile::desktop() && network.project.master.dc.sync_window.exponent > 7;
  if (machine.modes[1] == DcmMode::kMasterRefClock && !calm) machine.modes[1] = DcmMode::kMasterShift;
}

void draw_machine(SoakMachine& machine, Random& random) {
  auto& network = machine.network;
  add_branch(network, random);
  const bool bridge = add_bridge(network, random);
  draw_master(network, random);
  draw_slaves(network, random);
  machine.reference = draw_reference(network, random);
  draw_task(network, random);
  draw_group(network, random);
  draw_modes(machine, bridge, random);
}

bool has_sync0(const SoakMachine& machine, int slave) {
  return !machine.network.project.slaves[static_cast<std::size_t>(slave)].dc.op_mode.empty();
}

bool follows(const SoakMachine& machine, int slave) {
  return slave > static_cast<int>(machine.reference) && has_sync0(machine, slave);
}

/// Slow firmware of a slave that runs by itself shows in its SyncManager, where that is exchanged in each cycle; a
/// gateway counts it.
bool tells_by_itself(const SoakMachine& machine, int slave) {
  const auto& network = machine.network;
  if (has_sync0(machine, slave)) return false;
  if (network.sim.slaves[static_cast<std::size_t>(slave)].behaviour == "can-gateway") return true;
  return network.project.slaves[static_cast<std::size_t>(slave)].output_unit.empty();
}

bool has_clock(const test::SimulatedNetwork& network, std::size_t slave) {
  return network.sim.slaves[slave].dc.system_time;
}

/// Whether a fault of this kind at the kind's port has anything to do there, and can be seen.
bool has_there(const SoakMachine& machine, std::size_t slave, const SoakFaultKind& kind) {
  const auto& network = machine.network;
  std::size_t wired = 0, clocks = 0;
  for (std::size_t i = slave + 1; i < network.sim.slaves.size(); ++i) {
    if (network.sim.slaves[i].parent != slave) continue;
    ++wired;
    // Two of a kind that have changed places look like two that have not.
    const bool other = network.sim.slaves[i].behaviour != network.sim.slaves[slave].behaviour &&
                       network.project.slaves[i].hot_connect.empty();
    const bool shows = kind.kind != FaultKind::kReversedCable || other;
    if (network.sim.slaves[i].parent_port == kind.port && has_clock(network, i) && shows) ++clocks;
  }
  // Nothing but the times of its frames tells a ring that is closed from a branch.
  if (kind.kind == FaultKind::kClosedRing) return false;
  return wired == 1 && clocks == 1 && has_clock(network, slave);
}

}  // namespace

SoakMachine soak_machine(Random& random, SoakShape shape) {
  SoakMachine machine;
  machine.shape = shape;
  auto& network = machine.network;
  network.sim.host_jitter.wake_up = JitterProfile::quiet().wake_up;
  if (shape == SoakShape::kTree) {
    draw_whole_tree(machine, random);
  } else {
    add_line(network);
  }
  if (shape == SoakShape::kDrawn) draw_machine(machine, random);
  for (auto& slave : network.sim.slaves) {
    slave.oscillator.ppm = random.uniform(-45, 45);
    slave.oscillator.start_offset = static_cast<Nanoseconds>(random.uniform(0, 4e9));
    slave.cable_m = random.uniform(0.5, 60);
  }
  network.project.master.dc.sync_window.enabled = true;
  return machine;
}

std::vector<const SoakFaultKind*> kinds_for(const SoakMachine& machine) {
  std::vector<const SoakFaultKind*> kinds;
  for (const auto& kind : soak_fault_kinds()) {
    if (kind.victims.empty() || !victims(machine, kind).empty()) kinds.push_back(&kind);
  }
  return kinds;
}

Nanoseconds own_cycle(const SoakMachine& machine, int slave) {
  const auto& project = machine.network.project;
  const auto cycle = project.master.cycle_time;
  if (slave < 0 || !has_sync0(machine, slave)) return cycle;
  const auto& own = project.slaves[static_cast<std::size_t>(slave)];
  const auto units = own.output_unit.empty() ? 1 : project.master.tasks.front().multiple;
  return cycle * units * own.dc.sync0.cycle_factor.value_or(1);
}

std::vector<int> victims(const SoakMachine& machine, const SoakFaultKind& kind) {
  if (kind.of_reference) return {static_cast<int>(machine.reference)};
  const auto& slaves = machine.network.sim.slaves;
  const bool is_tree = machine.shape == SoakShape::kTree;
  auto all = is_tree ? std::vector<int>{} : kind.victims;
  // What concerns another port than the one to the master asks for somebody there.
  const auto first = is_tree ? std::size_t{kind.victims.empty() || kind.victims.front() > 0} : kLine;
  for (std::size_t i = first; (is_tree || kind.port == 0) && i < slaves.size(); ++i) {
    const bool is_like_one = std::ranges::any_of(
        kind.victims, [&](int victim) { return kBehaviours[static_cast<std::size_t>(victim)] == slaves[i].behaviour; });
    if (is_like_one && (kind.port == 0 || has_there(machine, i, kind))) all.push_back(static_cast<int>(i));
  }
  std::erase_if(all, [&](int slave) {
    return (kind.of_clock && !follows(machine, slave)) || (kind.with_sync0 && !has_sync0(machine, slave)) ||
           (kind.by_itself && !tells_by_itself(machine, slave));
  });
  return all;
}

std::string text_of(const SoakMachine& machine) {
  const auto& network = machine.network;
  const auto& master = network.project.master;
  const auto& jitter = network.sim.host_jitter;
  auto text = fmt::format(
      "{} slaves, slave {} leads{}, {} and {}, {} ms, window of {} ns, {} computer as host", network.sim.slaves.size(),
      machine.reference, master.dc.reference_clock ? " (one with a clock is in front of it)" : "",
      dcm_mode_name(machine.modes[0]), dcm_mode_name(machine.modes[1]),
      static_cast<double>(master.cycle_time) / kMillisecond, (1U << master.dc.sync_window.exponent) - 1,
      jitter == JitterProfile::desktop() ? "a desktop" : "a quiet");
  if (jitter.stamp_error.empty()) text += " with exact stamps";
  if (!master.tasks.empty()) text += fmt::format(", a task every {} cycles", master.tasks.front().multiple);
  if (machine.shape == SoakShape::kTree) return text + tree_text(network);
  if (!network.project.slaves[2].output_unit.empty()) text += " with a servo";
  if (network.sim.slaves.size() > kLine && !network.project.slaves[kLine].hot_connect.empty())
    text += ", the branch may be unplugged";
  return text;
}

}  // namespace syncline::bench
