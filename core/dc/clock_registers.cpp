// SPDX-License-Identifier: Apache-2.0
#include "dc/clock_registers.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {

std::uint16_t speed_counter_start(Nanoseconds cycle) {
  constexpr double kShare = 0.2, kSmallest = 0x0100, kLargest = 0x3FFF;
  const auto wanted = std::sqrt(static_cast<double>(std::max<Nanoseconds>(cycle, 0)) / (5 * kShare));
  return static_cast<std::uint16_t>(std::lround(std::clamp(wanted, kSmallest, kLargest)));
}

Nanoseconds extend_32bit(std::uint32_t low, Nanoseconds nearby) {
  const auto difference = static_cast<std::int32_t>(low - static_cast<std::uint32_t>(nearby));
  return nearby + difference;
}

Nanoseconds wrap_to_half(Nanoseconds value, Nanoseconds period) {
  auto rest = value % period;
  if (rest > period / 2) rest -= period;
  if (rest <= -((period + 1) / 2)) rest += period;
  return rest;
}

}  // namespace syncline::dc
