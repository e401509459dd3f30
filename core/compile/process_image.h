// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compile/compile.h"

namespace syncline::compiler {

struct SlavePlan;

/// One process-data command of the cyclic frame(s).
struct LogicalDatagram {
  Command command = Command::kLrw;
  std::uint32_t logical_address = 0;
  std::uint16_t length = 0;
  std::uint16_t expected_wkc = 0;
  std::size_t task = 0;  // 0 is the base task, 1.. those of MasterSettings::tasks
  bool operator==(const LogicalDatagram&) const = default;
};

struct ImageLayout {
  std::vector<LogicalDatagram> datagrams;
};

inline constexpr std::uint32_t kEcEngineerLogicalBase = 0x1000'0000;
inline constexpr std::uint32_t kTwinCatLogicalBase = 0x0100'0000;
inline constexpr std::uint32_t kTwinCatAreaStep = 0x800;
inline constexpr std::uint32_t kMailboxStateLogicalBase = 0x0900'0000;

struct ImageOptions {
  EniDialect dialect = EniDialect::kEcEngineer;
  std::uint16_t max_length = 0;  // bytes of a datagram
  bool overlap = true;           // both directions of a slave at the same address
  std::uint8_t alignment = 1;    // bytes; where the data of a slave may begin
  std::optional<std::uint32_t> logical_start{};
  std::vector<std::size_t> unit_tasks{0};  // of each Sync Unit; at least the unnamed one's, which is the base task

  [[nodiscard]] std::uint32_t logical_base() const {
    return logical_start.value_or(dialect == EniDialect::kEcEngineer ? kEcEngineerLogicalBase : kTwinCatLogicalBase);
  }
};

/// Places the process data of every slave in the logical address space and cuts it into datagrams at slave boundaries.
/// Fills SlavePlan::outputs and inputs. Without overlap the directions lie apart: outputs first (EC-Engineer), or no
/// LRW area (TwinCAT). With it:
/// - EC-Engineer: one area, every slave max(outputs, inputs) bytes, both directions at the same address; LRW, behind it
///   LWR and LRD over the same addresses for slaves that cannot do LRW.
/// - TwinCAT: slaves with both directions (LRW), with outputs (LWR), with inputs (LRD), each kind from a 0x800
/// boundary;
///   byte-oriented slaves first, bit-oriented ones packed bit by bit behind them.
/// Each Sync Unit has datagrams of its own.
[[nodiscard]] ImageLayout layout_process_image(std::span<SlavePlan> slaves, const ImageOptions& options);

}  // namespace syncline::compiler
