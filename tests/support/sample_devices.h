// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include "config/project.h"

/// Devices made by hand, as an ESI reader would give them.
namespace syncline::sample {

[[nodiscard]] Pdo pdo(std::uint16_t index, std::string name, std::optional<std::uint8_t> manager,
                      std::vector<PdoEntry> entries);

[[nodiscard]] SyncManagerDescription manager(SyncManagerType type, std::uint16_t start, std::uint8_t control);

[[nodiscard]] DeviceDescription coupler();

/// Two-channel digital input without mailbox.
[[nodiscard]] DeviceDescription digital_input();

/// Two-channel digital output whose SyncManager is open in OP only.
[[nodiscard]] DeviceDescription digital_output();

[[nodiscard]] DcOpMode op_mode(std::string name, std::uint16_t assign_activate, int sync0_factor);

/// CoE servo with DC: PDO assignment, one configurable PDO, 0x60C2 in its start-up list.
[[nodiscard]] DeviceDescription servo();

/// The ESI's defaults at a position of a line.
[[nodiscard]] SlaveSettings slave(DeviceDescription device, std::uint16_t position);

[[nodiscard]] Project project(std::vector<DeviceDescription> devices);

/// Coupler, digital input, digital output, servo.
[[nodiscard]] Project small_machine();

}  // namespace syncline::sample
