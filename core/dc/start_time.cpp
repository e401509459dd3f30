// SPDX-License-Identifier: Apache-2.0
#include "dc/start_time.h"

namespace syncline::dc {

Nanoseconds start_time(const StartTimeInput& input) {
  const auto earliest = input.now + input.safety;
  const auto grid = input.grid > 0 ? input.grid : 1;
  auto phase = (earliest - input.base) % grid;
  if (phase < 0) phase += grid;
  return earliest + (phase == 0 ? 0 : grid - phase) + input.shift;
}

}  // namespace syncline::dc
