// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sim/dc/local_clock.h"
#include "sim/dc/time_control_loop.h"

namespace syncline::sim {

/// Rates of the correction for what the speed counter shows: in nearly every frame another value, but the same few over
/// and over, each of which takes a division.
class CorrectionRates {
 public:
  [[nodiscard]] std::int64_t of(const TimeControlLoop& loop) {
    const auto start = loop.speed_counter_start();
    const auto diff = loop.speed_counter_diff();
    auto& known = known_[static_cast<std::uint32_t>(diff) % kKnown];
    if (known.start != start || known.diff != diff) known = {start, diff, LocalClock::rate_of(loop.correction())};
    return known.rate;
  }

 private:
  static constexpr std::uint32_t kKnown = 32;  // a loop that has settled moves over more than a dozen
  struct Known {
    std::uint16_t start = 0;  // none: it is never so small
    std::int32_t diff = 0;
    std::int64_t rate = 0;
  };
  std::array<Known, kKnown> known_{};
};

}  // namespace syncline::sim
