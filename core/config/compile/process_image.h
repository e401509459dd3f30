// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/compile/compile.h"
#include "config/compile/slave_plan.h"

namespace syncline::compiler {

/// One process-data command of the cyclic frame(s).
struct LogicalDatagram {
  Command command = Command::kLrw;
  std::uint32_t logical_address = 0;
  std::uint16_t length = 0;
  std::uint16_t expected_wkc = 0;
  bool operator==(const LogicalDatagram&) const = default;
};

struct ImageLayout {
  std::vector<LogicalDatagram> datagrams;
};

inline constexpr std::uint32_t kEcEngineerLogicalBase = 0x1000'0000;
inline constexpr std::uint32_t kTwinCatLogicalBase = 0x0100'0000;
inline constexpr std::uint32_t kTwinCatAreaStep = 0x800;
inline constexpr std::uint32_t kMailboxStateLogicalBase = 0x0900'0000;

/// Places the process data of every slave in the logical address space and cuts it into datagrams of at most
/// `max_length` bytes at slave boundaries. Fills SlavePlan::outputs and inputs.
/// - EC-Engineer: one area, every slave max(outputs, inputs) bytes, both directions at the same address; LRW, or LWR and
///   LRD over the same addresses as soon as one slave cannot do LRW.
/// - TwinCAT: slaves with both directions (LRW), with outputs (LWR), with inputs (LRD), each kind from a 0x800 boundary;
///   byte-oriented slaves first, bit-oriented ones packed bit by bit behind them.
[[nodiscard]] ImageLayout layout_process_image(std::span<SlavePlan> slaves, EniDialect dialect, std::uint16_t max_length);

}  // namespace syncline::compiler
