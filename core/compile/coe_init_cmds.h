// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "compile/compile.h"
#include "support/types.h"

namespace syncline::compiler {

struct SlavePlan;

/// Interpolation time period of a drive, CiA 402.
inline constexpr std::uint16_t kInterpolationTimePeriod = 0x60C2;

/// The CoE downloads of a slave, in order: list of its modules (0xF030), PDO assignment cleared, mappings of the PDOs
/// that are not fixed, PDO assignment, synchronisation type of the op mode, then the start-up list and the objects that
/// settings stand for (sync_commands). Empty for a slave without CoE.
[[nodiscard]] std::vector<CoeInitCmd> coe_init_cmds(const SlavePlan& slave, EniDialect dialect);

/// Object 0x60C2 (CiA 402): cycle = value * 10^exponent s. Empty when a byte cannot say it exactly.
struct InterpolationTime {
  std::uint8_t value = 0;
  std::int8_t exponent = -3;
  bool operator==(const InterpolationTime&) const = default;
};
[[nodiscard]] std::optional<InterpolationTime> interpolation_time(Nanoseconds cycle);

}  // namespace syncline::compiler
