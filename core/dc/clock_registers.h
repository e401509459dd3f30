// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/types.h"

/// What to write to the registers of a clock: offset 0x0920, start time 0x0990, speed counter 0x0930. Pure.
namespace syncline::dc {

/// SystemTimeOffset 0x0920 that makes the local copy equal the reference's time at the same instant:
/// system time wanted at the reference when the latch frame passed it, the slave's local latch time
/// (0x0918, or port 0 for a 32-bit clock) and the propagation delay.
[[nodiscard]] std::uint64_t system_time_offset(Nanoseconds reference_time_at_latch, std::uint64_t local_time_at_latch,
                                               std::uint32_t delay_ns, bool clock_is_64bit);

struct StartTimeInput {
  Nanoseconds now = 0;  // system time of the reference clock
  Nanoseconds safety = 5 * kMillisecond;
  Nanoseconds grid = kMillisecond;  // cycle, LCM of cycles, or the network grid
  Nanoseconds base = 0;             // phase of the DC base: SYNC0 instants are base + n * grid
  Nanoseconds shift = 0;            // of this slave
};
/// First grid point at or behind now + safety, plus the shift.
[[nodiscard]] Nanoseconds start_time(const StartTimeInput& input);

/// SpeedCounterStart 0x0930 with which a clock that is told the time once a `cycle` takes back about a fifth of its
/// error each time: one count of the speed counter is a rate of 1 / (5 S^2) (ESC data sheet I, 9.1.4). Within
/// 0x0100 .. 0x3FFF; a longer cycle gives a larger value, the reset value 0x1000 belongs to 17 ms.
[[nodiscard]] std::uint16_t speed_counter_start(Nanoseconds cycle);

/// Extends a 32-bit reading of a system time by a nearby full time.
[[nodiscard]] Nanoseconds extend_32bit(std::uint32_t low, Nanoseconds nearby);

/// value folded into (-period/2, period/2].
[[nodiscard]] Nanoseconds wrap_to_half(Nanoseconds value, Nanoseconds period);

}  // namespace syncline::dc
