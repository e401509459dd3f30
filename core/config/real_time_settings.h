// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline {

/// Of the thread that runs the cycle on the real clock.
struct RealTimeSettings {
  /// So much of the end of each wait is spent at most asking the clock instead of sleeping: earlier wake-ups for
  /// processor time. Used is what the host needs (master/cyclic/spin_budget.h).
  Nanoseconds spin = 50 * kMicrosecond;  // 0..1 ms, at most a quarter of the cycle is used
  /// Processor that the thread is bound to.
  std::optional<std::uint16_t> cpu;
  bool operator==(const RealTimeSettings&) const = default;
};

}  // namespace syncline
