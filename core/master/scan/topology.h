// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/previous_port.h"
#include "protocol/dl_status.h"

namespace syncline {

/// What one slave says about its ports.
struct PortReport {
  DlStatus dl_status;
  /// Local times at which a frame came in at each port (0x0900), for slaves that have them; those of
  /// closed ports mean nothing.
  std::optional<std::array<std::uint32_t, kPortCount>> receive_times;
};

/// Where one slave hangs.
struct SlaveWiring {
  std::optional<PreviousPort> previous;  // empty where the master's frames come from the master
  std::uint8_t entry_port = 0;           // towards the master
  bool root = false;                     // connected to the master
  /// Active ports behind which no slave was found, one bit a port.
  std::uint8_t unexplained_ports = 0;
  /// Active ports whose receive times cannot be, one bit a port; who hangs there is known all the same.
  std::uint8_t untimed_ports = 0;
};

/// The port through which frames from the master arrive: the open one with the earliest receive time
/// (counters wrap; differences are small). Without receive times port 0, or the first open one where that is closed.
[[nodiscard]] std::uint8_t entry_port(const PortReport& slave);

/// The whole tree, for slaves in the order in which frames pass their processing units: frames leave a slave by its
/// open ports in the order 3, 1, 2. No predecessor where the open ports do not explain the position; a receive
/// time that contradicts the others is of a foreign frame, or means nothing. A slave that
/// is connected by another port than 0 forwards before it processes, so slaves behind its ports between the entry and
/// port 0 come before it. Where the order does not fit, the entries of slaves without receive times are taken as what
/// explains most. Pure.
[[nodiscard]] std::vector<SlaveWiring> find_wiring(std::span<const PortReport> slaves);

}  // namespace syncline
