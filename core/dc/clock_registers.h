// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/types.h"

/// What to write to the registers of a clock beside its offset and start time, and how its times are read. Pure.
namespace syncline::dc {

/// SpeedCounterStart 0x0930 with which a clock that is told the time once a `cycle` takes back about a fifth of its
/// error each time: one count of the speed counter is a rate of 1 / (5 S^2) (ESC data sheet I, 9.1.4). Within
/// 0x0100 .. 0x3FFF; a longer cycle gives a larger value, the reset value 0x1000 belongs to 17 ms.
[[nodiscard]] std::uint16_t speed_counter_start(Nanoseconds cycle);

/// Extends a 32-bit reading of a system time by a nearby full time.
[[nodiscard]] Nanoseconds extend_32bit(std::uint32_t low, Nanoseconds nearby);

/// value folded into (-period/2, period/2].
[[nodiscard]] Nanoseconds wrap_to_half(Nanoseconds value, Nanoseconds period);

}  // namespace syncline::dc
