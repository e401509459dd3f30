// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/types.h"

namespace syncline {

class MinMaxSeries;

/// Where in a SYNC0 period outputs came over a stretch of time: all arrivals of it, exactly. Times in ns.
struct ArrivalFigures {
  struct Bin {
    std::uint64_t count = 0;
    Nanoseconds newest = 0;  // host clock, of the latest arrival in it
    bool operator==(const Bin&) const = default;
  };
  std::vector<Bin> bins;  // equal parts of the period; the first begins with SYNC0
  std::uint64_t count = 0;
  std::optional<Nanoseconds> margin_min;   // the shortest distance to the SYNC0 that uses what came
  std::optional<Nanoseconds> margin_p999;  // 99.9 % of all came at least so early
  bool operator==(const ArrivalFigures&) const = default;
};
/// `phase`: Signal::kArrivalPhase in [begin, end), of a SYNC0 with `period` > 0.
[[nodiscard]] ArrivalFigures arrival_figures(const MinMaxSeries& phase, Nanoseconds period, Nanoseconds begin,
                                             Nanoseconds end, std::size_t bins);

}  // namespace syncline
