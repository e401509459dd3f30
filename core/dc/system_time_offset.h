// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/types.h"

namespace syncline::dc {

/// SystemTimeOffset 0x0920 that makes the local copy equal the reference's time at the same instant:
/// system time wanted at the reference when the latch frame passed it, the slave's local latch time
/// (0x0918, or port 0 for a 32-bit clock) and the propagation delay.
[[nodiscard]] std::uint64_t system_time_offset(Nanoseconds reference_time_at_latch, std::uint64_t local_time_at_latch,
                                               std::uint32_t delay_ns, bool clock_is_64bit);

}  // namespace syncline::dc
