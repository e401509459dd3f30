// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sim/dc/local_clock.h"
#include "sim/dc/time_control_loop.h"

namespace syncline::sim {

/// Rates of the correction for what speed counters show: in nearly every frame another value, but the same few over and
/// over, each of which takes a division. Kept once for all ESCs of a thread: a hundred that have each their own do not
/// stay near the processor.
[[nodiscard]] inline std::int64_t correction_rate(const TimeControlLoop& loop) {
  struct Known {
    std::uint16_t start = 0;  // none: it is never so small
    std::int32_t diff = 0;
    std::int64_t rate = 0;
  };
  constexpr std::uint32_t kKnown = 1024;
  static thread_local constinit std::array<Known, kKnown> known{};
  const auto start = loop.speed_counter_start();
  const auto diff = loop.speed_counter_diff();
  auto& one = known[(static_cast<std::uint32_t>(diff) + std::uint32_t{start} * 41) % kKnown];
  if (one.start != start || one.diff != diff) one = {start, diff, LocalClock::rate_of(loop.correction())};
  return one.rate;
}

}  // namespace syncline::sim
