// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tests/support/sample_devices.h"

/// A device that modules are plugged into.
namespace syncline::sample {

inline constexpr std::uint32_t kAxis = 0x100, kIo = 0x200;

inline ModuleDescription module(std::uint32_t ident, std::uint16_t rx, std::uint16_t tx, std::uint16_t object,
                                std::uint16_t bits) {
  ModuleDescription out;
  out.ident = ident;
  out.type = "M" + std::to_string(ident);
  Pdo outputs = pdo(rx, "Outputs", 2, {{object, 1, bits, "Out", "UINT", false, true}});
  Pdo inputs = pdo(tx, "Inputs", 3, {{static_cast<std::uint16_t>(object + 1), 1, bits, "In", "UINT", false, true}});
  outputs.depend_on_slot = inputs.depend_on_slot = true;
  out.rx_pdos = {outputs};
  out.tx_pdos = {inputs};
  StartupCommand command;
  command.index = 0x8000;
  command.data = {1};
  command.depend_on_slot = true;
  out.coe.emplace().init_commands = {command};
  return out;
}

/// One place without increments, then three in a row: PDOs 0x10 apart, objects 0x800 apart.
inline DeviceDescription gateway() {
  DeviceDescription device = servo();
  device.rx_pdos.clear();
  device.tx_pdos.clear();
  device.dc.reset();
  device.modules = {module(kAxis, 0x1600, 0x1A00, 0x6040, 16), module(kIo, 0x1601, 0x1A01, 0x7000, 8)};
  SlotDescription status, axes;
  status.max_instances = 1;
  status.modules = {{kIo, false}};
  axes.name = "Axis";
  axes.min_instances = 1;
  axes.max_instances = 3;
  axes.modules = {{kAxis, true}, {kIo, false}};
  axes.increments.slot_pdo = 0x10;
  axes.increments.slot_index = 0x800;
  device.slots.emplace().slots = {status, axes};
  device.download_module_list = true;
  return device;
}

}  // namespace syncline::sample
