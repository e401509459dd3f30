// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "dc/propagation_delay.h"
#include "protocol/dl_status.h"
#include "tests/core/sim/sim_probe.h"

/// The simulated wires, and what a master makes of the registers behind them.
namespace syncline::test {
namespace {

/// The delays that the registers give are those that the wires have: latch, read, compute.
TEST(SimulatedDelays, MeasuredDelaysOfTheDemonstrationMachineAreTheTrueOnes) {
  const auto config = sim::load_scenario(resource("demo/machine.toml"), scenario_device).value();
  SimProbe probe(config);
  constexpr int kRounds = 15;
  const auto count = config.slaves.size();
  std::vector<std::array<std::vector<std::int32_t>, 4>> since_entry(count);
  for (int round = 0; round < kRounds; ++round) {
    probe.send(Command::kBwr, device_address(0, reg::kReceiveTimePort0), {0, 0, 0, 0});
    for (std::uint16_t i = 0; i < count; ++i) {
      const auto times = probe.read(i, reg::kReceiveTimePort0, 16);
      if (times.wkc == 0) continue;
      for (unsigned port = 0; port < 4; ++port) {
        const auto bytes = std::span(times.data);
        since_entry[i][port].push_back(
            static_cast<std::int32_t>(load_le<std::uint32_t>(bytes.subspan(4 * port)) - load_le<std::uint32_t>(bytes)));
      }
    }
    probe.pass(kMillisecond + 137);  // another phase of the 10 ns counters
  }
  std::vector<dc::DelayNode> nodes(count);
  for (std::uint16_t i = 0; i < count; ++i) {
    const DlStatus status{probe.read(i, reg::kDlStatus, 2).value<std::uint16_t>()};
    nodes[i].parent = config.slaves[i].parent;
    nodes[i].parent_port = config.slaves[i].parent_port;
    if (since_entry[i][0].empty()) continue;
    const bool full = probe.read(i, reg::kSystemTime, 4).wkc == 1;
    nodes[i].kind = full ? dc::DcKind::kFull : dc::DcKind::kReceiveTimesOnly;
    for (unsigned port = 0; port < 4; ++port) {
      nodes[i].active[port] = status.active(port);
      auto& values = since_entry[i][port];
      std::ranges::nth_element(values, values.begin() + kRounds / 2);
      nodes[i].receive_time[port] = static_cast<std::uint32_t>(values[kRounds / 2]);
    }
  }
  const auto result = dc::propagation_delays(nodes);
  int compared = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!result.delay_ns[i]) continue;
    EXPECT_NEAR(static_cast<double>(*result.delay_ns[i]), probe.bus->true_delay_ns(i), 20) << config.slaves[i].name;
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

}  // namespace
}  // namespace syncline::test
