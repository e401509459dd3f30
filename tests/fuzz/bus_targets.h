// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fuzz/targets.h"

namespace syncline::fuzz {

/// Any datagrams at any times to a simulated segment of mixed devices.
void run_bus(std::span<const std::uint8_t> bytes);
/// A master that scans a simulated machine and brings it up over a link that damages, shortens, doubles, reorders and
/// makes up what comes back.
void run_master(std::span<const std::uint8_t> bytes);
/// SDO, SDO information and FoE clients with a slave whose mailbox lies.
void run_clients(std::span<const std::uint8_t> bytes);

[[nodiscard]] std::vector<Bytes> bus_scripts();
[[nodiscard]] std::vector<Bytes> master_scripts();
[[nodiscard]] std::vector<Bytes> client_scripts();

}  // namespace syncline::fuzz
