// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "channels/values/delay_warning.h"

namespace syncline::dc {

enum class DcKind : std::uint8_t { kNone, kReceiveTimesOnly, kFull };

/// What one slave contributes to the delay measurement. Frame order; a parent stands before its child.
struct DelayNode {
  DcKind kind = DcKind::kNone;
  std::array<bool, 4> active{};                  // open and communicating ports
  std::array<std::uint32_t, 4> receive_time{};   // 0x0900.., meaningless on inactive ports,
  std::array<bool, 4> untimed{};                 // and on these
  std::optional<std::uint32_t> processing_time;  // low half of 0x0918 of the same latch, where there is one
  std::optional<std::uint16_t> parent;           // position of the predecessor in the tree
  std::uint8_t parent_port = 1;                  // port of the parent that leads here
  std::uint8_t entry_port = 0;  // towards the master, of a slave without receive times; the others tell
  std::array<bool, 4> ebus{};   // ports without a PHY (0x0007)
};

struct DelayOptions {
  /// Processing minus forwarding latency of every ESC; empty: the usual one of the port that a frame leaves by.
  std::optional<std::uint32_t> t_diff_ns{};
};

struct DelayFinding {
  std::uint16_t position = 0;
  DelayWarning warning = DelayWarning::kNegativeHop;
  std::int64_t value_ns = 0;
};
struct DelayResult {
  /// Per position, from processing unit to processing unit, the least is 0; empty: no receive times.
  std::vector<std::optional<std::uint32_t>> delay_ns;
  std::vector<std::uint8_t> entry_port;
  std::vector<DelayFinding> findings;
};

/// Delays of the whole segment, depth first in port order 0-3-1-2 (reference: ESC data sheet I, 9.1.2). The delay of a
/// slave that is entered by another port than 0 runs to where its processing unit lies, behind port 0: 0x0910 and
/// 0x0918 are the times of the frame there (data sheet II, 0x0918: with port 0 open the receive time of port 0). Pure.
/// Call with medians of several latch rounds.
[[nodiscard]] DelayResult propagation_delays(std::span<const DelayNode> nodes, const DelayOptions& options = {});

}  // namespace syncline::dc
