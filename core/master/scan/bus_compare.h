// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "protocol/sync_manager.h"
#include "support/result.h"

namespace syncline {

class Bus;
struct BusScan;
struct ConfigDifference;
struct NetworkConfig;

/// What a slave in SAFEOP or OP has in its registers.
struct RunningRegisters {
  static constexpr std::size_t kManagers = 8;
  std::array<SyncManager, kManagers> managers;
  std::uint16_t activation = 0;                    // 0x0980
  std::uint32_t cycle_time0 = 0, cycle_time1 = 0;  // 0x09A0, 0x09A4, ns
  bool operator==(const RunningRegisters&) const = default;
};

/// Reads them of every scanned slave that is in SAFEOP or OP; only reads. kNoResponse, kCancelled, link errors.
[[nodiscard]] Result<std::vector<std::optional<RunningRegisters>>> read_running_registers(Bus& bus,
                                                                                          const BusScan& scan);

/// What a bus has that a configuration does not expect, left = configuration, right = bus: slaves by identity and
/// order, serial numbers and aliases where they are configured, wiring, clocks that are missing, mailboxes, and of
/// running slaves the sizes of process data and the SYNC settings. `running` may be shorter than the scan.
[[nodiscard]] std::vector<ConfigDifference> compare_with_bus(
    const NetworkConfig& config, const BusScan& scan, std::span<const std::optional<RunningRegisters>> running = {});

}  // namespace syncline
