// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "config/sim_config.h"
#include "master/clocks/clock_segment.h"
#include "master/scan/topology.h"
#include "sim/segment/segment.h"
#include "support/random.h"

namespace syncline {
namespace {

/// A line with branches at some of its slaves, each behind port C.
struct Machine {
  std::vector<SimSlaveConfig> slaves;
  std::size_t last = 0;  // of the line

  explicit Machine(Random& random) {
    const auto line = 1 + random.next() % 7;
    for (std::size_t i = 0; i < line; ++i) add(i == 0 ? std::nullopt : std::optional(i - 1), 1, random);
    last = line - 1;
    for (std::size_t root = line; root-- > 0;) {  // the frames come to the branches on their way back
      if (random.next() % 2 == 0) continue;
      for (std::uint64_t n = 1 + random.next() % 6, i = 0; i < n; ++i)
        add(i == 0 ? root : slaves.size() - 1, i == 0 ? 2 : 1, random);
    }
  }

  void add(std::optional<std::size_t> parent, std::uint8_t port, Random& random) {
    SimSlaveConfig slave;
    if (parent) slave.parent = static_cast<std::uint16_t>(*parent);
    slave.parent_port = port;
    slave.cable_m = random.uniform(0.5, 60);
    slave.asymmetry_ns = random.uniform(-20, 20);
    slaves.push_back(slave);
  }
};

/// What the slaves say after a latch, and how long the frame really took to each. `ring_ns`: the last slave's port B
/// leads to the host's other adapter, whose frame comes there so long after the master's was sent.
struct Latch {
  std::vector<PortReport> reports;
  std::vector<double> delay_ns;

  Latch(const Machine& machine, std::optional<double> ring_ns, Random& random)
      : reports(machine.slaves.size()), delay_ns(machine.slaves.size()) {
    sim::Wiring wiring(machine.slaves);
    auto ports = all_connected(machine.slaves, wiring);
    if (ring_ns) {
      wiring.close_ring(sim::Wiring::Ring{static_cast<std::uint16_t>(machine.last), 1, *ring_ns});
      ports[machine.last].link[1] = ports[machine.last].open[1] = true;
    }
    for (std::size_t i = 0; i < reports.size(); ++i) {
      unsigned value = 1;
      for (unsigned port = 0; port < kPortCount; ++port)
        value |= ports[i].open[port] ? 1U << (9 + 2 * port) | 1U << (4 + port) : 1U << (8 + 2 * port);
      reports[i] = {DlStatus{static_cast<std::uint16_t>(value)}, std::array<std::uint32_t, kPortCount>{}};
    }
    const auto path = segment_path(machine.slaves, wiring, ports);
    for (const auto& passage : path.passages) {
      const auto noise = static_cast<Nanoseconds>(random.uniform(0, 12));
      (*reports[passage.slave].receive_times)[passage.port] =
          static_cast<std::uint32_t>(7'777'777 * passage.slave + passage.offset + noise);
      if (passage.first) delay_ns[passage.slave] = passage.time_ns - path.passages.front().time_ns;
    }
  }
};

/// Everybody hangs where he does, and nothing but `unexplained` is a port with nobody behind it.
bool is_found(const Machine& machine, std::span<const SlaveWiring> found, std::optional<std::size_t> unexplained) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& slave = machine.slaves[i];
    if (found[i].root == slave.parent.has_value() || found[i].root == found[i].previous.has_value()) return false;
    if (slave.parent && found[i].previous != PreviousPort{*slave.parent, slave.parent_port}) return false;
    if (found[i].entry_port != 0 || found[i].unexplained_ports != (i == unexplained ? 0b10 : 0)) return false;
  }
  return true;
}

/// A frame of another adapter says nothing about the way of the master's, and may come when that one could: then
/// nothing tells it from a slave there, which is seldom.
TEST(ForeignTimes, AClosedRingIsWhereItIsWheneverItsFrameComes) {
  constexpr int kMachines = 2'000;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= kMachines; ++seed) {
    Random random(seed);
    const Machine machine(random);
    const Latch latch(machine, random.uniform(100, 5'000), random);
    found += is_found(machine, find_wiring(latch.reports), machine.last) ? 1 : 0;
  }
  RecordProperty("found", found);
  EXPECT_GE(found, kMachines * 9 / 10);
}

/// A register that holds what it held before costs nobody his place, and nobody a delay but those around it, whose
/// cables are left out.
TEST(ForeignTimes, APortTimeThatStandsStillIsNobodysPlaceAndNobodysDelay) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Machine machine(random);
    if (machine.slaves.size() == 1) continue;
    Latch latch(machine, std::nullopt, random);
    const auto child = 1 + random.next() % (machine.slaves.size() - 1);
    const auto& [parent, port] = std::pair(*machine.slaves[child].parent, machine.slaves[child].parent_port);
    auto& times = *latch.reports[parent].receive_times;
    times[port] = times[0] + 10'000'000 + static_cast<std::uint32_t>(random.uniform(0, 4.27e9));

    std::vector<dc::DelayNode> nodes(latch.reports.size());
    std::vector<DlStatus> statuses;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i].kind = dc::DcKind::kFull;
      nodes[i].receive_time = *latch.reports[i].receive_times;
      for (unsigned p = 0; p < kPortCount; ++p) nodes[i].active[p] = latch.reports[i].dl_status.active(p);
      statuses.push_back(latch.reports[i].dl_status);
    }
    const auto wiring = segment_wiring(nodes, statuses);
    ASSERT_TRUE(is_found(machine, wiring, std::nullopt));
    EXPECT_EQ(wiring[parent].untimed_ports, 1U << port);
    const auto result = segment_delays(nodes, wiring, true, {});
    EXPECT_TRUE(std::ranges::any_of(result.findings, [&, at = parent, which = port](const dc::DelayFinding& finding) {
      return finding.position == at && finding.warning == dc::DelayWarning::kUntimedPort && finding.value_ns == which;
    }));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      ASSERT_TRUE(result.delay_ns[i]);
      EXPECT_NEAR(*result.delay_ns[i], latch.delay_ns[i], i < parent ? 100 : 3'500) << i;
    }
    for (const auto& finding : result.findings) {
      EXPECT_TRUE(
          finding.warning == dc::DelayWarning::kUntimedPort || finding.warning == dc::DelayWarning::kImplausibleHop ||
          finding.warning == dc::DelayWarning::kNegativeHop || finding.warning == dc::DelayWarning::kNotIncreasing)
          << finding.position;
    }
  }
}

}  // namespace
}  // namespace syncline
