// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "master/scan/topology.h"

/// What a tree follows from: the order of the slaves, their open ports, and by which of them the frames come in.
namespace syncline::wiring {

/// Where the master's frames come in, the open ports behind which there is something else than slaves, and those whose
/// receive times mean nothing; a bit each.
struct Entry {
  std::uint8_t port = 0;
  unsigned foreign = 0, untimed = 0;
};

/// The ports by which frames come to a slave and go on, by their bits.
[[nodiscard]] unsigned open_ports(const DlStatus& status);
[[nodiscard]] constexpr bool holds(unsigned ports, unsigned port) { return (ports >> port & 1U) != 0; }
/// Of these ports the one with the earliest time; there is one at least.
[[nodiscard]] std::uint8_t first_of(unsigned ports, const std::array<std::uint32_t, kPortCount>& times);

/// Active ports of one slave as a frame from the master leaves by them, before and behind the processing
/// unit, which lies between port 0 and port 3.
struct Ways {
  std::vector<std::uint8_t> before, behind;
};

[[nodiscard]] Ways ways_of(unsigned open, std::uint8_t entry);

/// For how long a frame was away from a slave, in ns of its own clock: behind one port, or behind all of
/// them. Nothing without receive times that say it.
[[nodiscard]] std::optional<std::uint32_t> time_behind(const PortReport& slave, const Entry& entry,
                                                       std::optional<std::uint8_t> port);

/// Every slave at the port that the order and the times leave for it.
[[nodiscard]] std::vector<SlaveWiring> tree_of(std::span<const PortReport> slaves, std::span<const Entry> entries);
/// Slaves whose place nothing explains, and ports behind which nobody was found.
[[nodiscard]] std::size_t unexplained(std::span<const SlaveWiring> wiring);

}  // namespace syncline::wiring
