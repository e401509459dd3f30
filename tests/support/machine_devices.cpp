// SPDX-License-Identifier: Apache-2.0
#include "tests/support/machine_devices.h"

#include "tests/support/own_devices.h"

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

DeviceDescription large_io() {
  constexpr std::uint8_t kWords = 220;
  auto device = io8();
  device.type = device.name = "large";
  device.identity.product_code = 0x0111;
  for (auto* pdo : {&device.rx_pdos[0], &device.tx_pdos[0]}) {
    const auto first = pdo->entries[0];
    pdo->entries.clear();
    for (std::uint8_t sub = 1; sub <= kWords; ++sub) {
      pdo->entries.push_back(first);
      pdo->entries.back().sub_index = sub;
    }
  }
  device.sync_managers[0].default_size = device.sync_managers[1].default_size = 4 * kWords;
  device.sync_managers[1].start_address = 0x1D00;  // behind three buffers of the outputs
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

DeviceDescription servo() { return sample::own("SL-SV7"); }

}  // namespace syncline::test
