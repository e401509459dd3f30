// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline::dc {

/// Of the SYNC signals, 0x0990.
struct StartTimeInput {
  Nanoseconds now = 0;  // system time of the reference clock
  Nanoseconds safety = 5 * kMillisecond;
  Nanoseconds grid = kMillisecond;  // cycle, LCM of cycles, or the network grid
  Nanoseconds base = 0;             // phase of the DC base: SYNC0 instants are base + n * grid
  Nanoseconds shift = 0;            // of this slave
};
/// First grid point at or behind now + safety, plus the shift.
[[nodiscard]] Nanoseconds start_time(const StartTimeInput& input);

}  // namespace syncline::dc
