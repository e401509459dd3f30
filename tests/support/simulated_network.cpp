// SPDX-License-Identifier: Apache-2.0
#include "tests/support/simulated_network.h"

#include <fmt/format.h>

namespace syncline::test {

void SimulatedNetwork::add(const DeviceDescription& device, const std::string& behaviour) {
  const auto position = static_cast<std::uint16_t>(project.slaves.size());
  project.slaves.push_back(default_slave(device, position));
  auto& slave = project.slaves.back();
  slave.name = fmt::format("{} {}", device.type, position);
  slave.station_address = static_cast<std::uint16_t>(1001 + position);
  SimSlaveConfig simulated;
  simulated.name = slave.name;
  simulated.behaviour = behaviour;
  simulated.device = device;
  simulated.oscillator.ppm = static_cast<double>(position % 11) - 5;
  if (position > 0) {
    const auto before = static_cast<std::uint16_t>(position - 1);
    simulated.parent = before;
    slave.previous = PreviousPort{before, 1};
  }
  sim.slaves.push_back(std::move(simulated));
}

NetworkConfig SimulatedNetwork::compiled(const CompileOptions& options) const {
  auto result = compile(project, options);
  return result ? std::move(result->config) : NetworkConfig{};
}

std::unique_ptr<Link> SimulatedNetwork::link(Clock& clock) const {
  if (auto* own = dynamic_cast<VirtualClock*>(&clock)) add_standstills(*own, sim);
  auto bus = sim::SimBus::create(sim, clock.now());
  auto host = SimulatedHost::with(sim.host_jitter, sim.seed);
  host.adapter = AdapterFaults::of(sim, clock.now());
  return bus ? make_simulated_link("sim", std::move(*bus), clock, host) : nullptr;
}

}  // namespace syncline::test
