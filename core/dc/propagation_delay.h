// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace syncline::dc {

enum class DcKind : std::uint8_t { kNone, kReceiveTimesOnly, kFull };

/// What one slave contributes to the delay measurement. Frame order; a parent stands before its child.
struct DelayNode {
  DcKind kind = DcKind::kNone;
  std::array<bool, 4> active{};                 // open and communicating ports
  std::array<std::uint32_t, 4> receive_time{};  // 0x0900.., meaningless on inactive ports
  std::optional<std::uint16_t> parent;          // position of the predecessor in the tree
  std::uint8_t parent_port = 1;                 // port of the parent that leads here
};

struct DelayOptions {
  std::uint32_t t_diff_ns = 40;                 // processing minus forwarding latency of an ESC
};

enum class DelayWarning : std::uint8_t {
  kReversedCable,    // value: the port by which the slave is connected
  kNegativeHop,
  kImplausibleHop,
  kNotIncreasing,
  kUnexplainedPort,  // value: a port with a link behind which no slave is: a ring that is closed, another master
};
struct DelayFinding {
  std::uint16_t position = 0;
  DelayWarning warning = DelayWarning::kNegativeHop;
  std::int64_t value_ns = 0;
};
struct DelayResult {
  std::vector<std::optional<std::uint32_t>> delay_ns;  // per position, from the first DC slave; empty: no receive times
  std::vector<std::uint8_t> entry_port;
  std::vector<DelayFinding> findings;
};

/// Delays of the whole segment, depth first in port order 0-3-1-2 (reference: ESC data sheet I, 9.1.2).
/// Pure. Call with medians of several latch rounds.
[[nodiscard]] DelayResult propagation_delays(std::span<const DelayNode> nodes, const DelayOptions& options = {});

}  // namespace syncline::dc
