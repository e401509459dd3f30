// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline {

/// Speed counter start 0x0930 after reset (ESC data sheet, section II); writing it starts the loop anew.
inline constexpr std::uint16_t kSpeedCounterDefault = 0x1000;

/// Relative rate by which the time control loop slows a clock, from 0x0930 and 0x0932
/// (ESC data sheet I, 9.1.4: D / (5 (S+D+2)(S-D+2))).
[[nodiscard]] constexpr double speed_counter_rate(std::uint16_t start, std::int32_t diff) {
  const double s = start;
  const double d = diff;
  return d / (5.0 * (s + d + 2.0) * (s - d + 2.0));
}

}  // namespace syncline
