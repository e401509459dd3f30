// SPDX-License-Identifier: Apache-2.0
#include "tests/support/simulated_network.h"

#include <fmt/format.h>

#include "eni/esi/esi_reader.h"
#include "tests/support/source_dir.h"

namespace syncline::test {

DeviceDescription io8() {
  DeviceDescription device;
  device.identity = {0x5C17, 0x0108, 1, 0};
  device.type = device.name = "io8";
  device.physics = "KK";
  device.fmmus = {FmmuUse::kOutputs, FmmuUse::kInputs};
  device.sync_managers = {{SyncManagerType::kOutputs, 0x1000, {}, {}, 4, 0x64, true, false, false},
                          {SyncManagerType::kInputs, 0x1100, {}, {}, 4, 0x20, true, false, false}};
  Pdo outputs{0x1600, "Outputs", 0, true, true, {}, {{0x7000, 1, 32, "Out", "UDINT"}}};
  Pdo inputs{0x1A00, "Inputs", 1, true, true, {}, {{0x6000, 1, 32, "In", "UDINT"}}};
  device.rx_pdos = {outputs};
  device.tx_pdos = {inputs};
  device.dc.emplace();
  device.dc->op_modes.push_back({});
  device.dc->op_modes.front().name = "DC";
  device.dc->op_modes.front().assign_activate = 0x0300;
  device.dc->op_modes.front().cycle_time_sync0.factor = 1;
  return device;
}

DeviceDescription bridge() {
  auto device = io8();
  device.type = device.name = "bridge";
  device.identity.product_code = 0x0109;
  device.tx_pdos[0].entries = {{0x10F4, 0x11, 64, "Internal time", "ULINT"},
                               {0x10F4, 0x12, 64, "External time", "ULINT"}};
  return device;
}

DeviceDescription servo() {
  const auto file = eni::read_esi(source_dir() + "/resources/esi/SL-SV7.xml");
  return file && !file->devices.empty() ? file->devices.front() : DeviceDescription{};
}

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
  return bus ? make_simulated_link("sim", std::move(*bus), clock) : nullptr;
}

}  // namespace syncline::test
