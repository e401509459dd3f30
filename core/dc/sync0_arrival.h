// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/types.h"

/// Where in a slave's SYNC0 period its outputs come. Pure values.
namespace syncline::dc {

/// SYNC0 of a slave in system time, ns: at `first` + n * `period`, for n of either sign.
struct Sync0Grid {
  Nanoseconds first = 0;   // any SYNC0 of it
  Nanoseconds period = 0;  // > 0; a multiple or a fraction of the bus cycle
  bool operator==(const Sync0Grid&) const = default;
};

/// When outputs are at a slave, system time, ns: the frame passed the reference clock at `passed`, this slave is
/// `delay` behind that clock (register 0x0928), and SM2's event comes `wire` later with the end of the frame that
/// carries them (outputs_wire_time(); ESC data sheet I, 5.2).
[[nodiscard]] constexpr Nanoseconds outputs_arrival(Nanoseconds passed, Nanoseconds delay, Nanoseconds wire) {
  return passed + delay + wire;
}

/// What comes with a SYNC0 itself belongs to the period that begins with it.
struct Sync0Arrival {
  std::int64_t number = 0;  // of the period, 0 from Sync0Grid::first on
  Nanoseconds phase = 0;    // since the SYNC0 that began it: 0 .. period - 1
  Nanoseconds margin = 0;   // to the SYNC0 that uses what came: 0 .. period - 1; 0: it came with it
};
[[nodiscard]] constexpr Sync0Arrival sync0_arrival(const Sync0Grid& grid, Nanoseconds arrived) {
  const auto since = arrived - grid.first;
  auto number = since / grid.period;
  auto phase = since % grid.period;
  if (phase < 0) {
    phase += grid.period;
    --number;
  }
  return {number, phase, phase == 0 ? 0 : grid.period - phase};
}

/// From the moment at which a slave has its outputs to the SYNC0 that uses them, where frames pass the reference clock
/// `set_value` in front of the SYNC grid. `first`: of its SYNC0, behind that grid.
[[nodiscard]] constexpr Nanoseconds nominal_margin(Nanoseconds set_value, const Sync0Grid& grid, Nanoseconds delay,
                                                   Nanoseconds wire) {
  return sync0_arrival(grid, outputs_arrival(-set_value, delay, wire)).margin;
}

}  // namespace syncline::dc
