// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "support/types.h"

namespace syncline {

class MinMaxSeries;

/// How much room outputs keep to the two SYNC0 about them, and how sure that is: two walls, each the distance that is
/// kept in all but a part of the periods, down to one in a thousand million. Times in ns.
struct ArrivalBathtub {
  static constexpr double kLeastProbability = 1e-9;

  struct Point {
    double probability = 1;  // that a period has less room than `room`
    double room = 0;         // ns to that SYNC0; negative: on the other side of it
    /// Fewer than ten periods had less: it is what comes out if the rarest ones go on as they begin.
    bool extrapolated = false;
    bool operator==(const Point&) const = default;
  };
  /// Too late: room to the SYNC0 that uses the outputs. Too early: behind the one before, whose outputs it would
  /// replace. By falling probability, eight points a decade; extrapolated ones only where there are kFewest arrivals.
  std::vector<Point> late, early;
  std::uint64_t count = 0;  // arrivals

  /// The room kept in all but that part of the periods; nothing where nobody can tell.
  [[nodiscard]] static std::optional<Point> room(const std::vector<Point>& wall, double probability);
  /// In which part of the periods less than `need` (ns) is kept; nothing: in fewer than one can tell, or than
  /// kLeastProbability.
  [[nodiscard]] static std::optional<Point> less_than(const std::vector<Point>& wall, double need);
  bool operator==(const ArrivalBathtub&) const = default;
};
inline constexpr std::uint64_t kFewestArrivals = 2'000;

/// `phase`: Signal::kArrivalPhase in [begin, end), of a SYNC0 with `period` > 0. Which SYNC0 an arrival belongs to is
/// told by most of them: one that is beyond it by up to half a period has come too late or too early for it.
/// Extrapolated are the rarest hundredth (twenty arrivals at least, a thousand at most) as an exponential tail.
[[nodiscard]] ArrivalBathtub arrival_bathtub(const MinMaxSeries& phase, Nanoseconds period, Nanoseconds begin,
                                             Nanoseconds end);

}  // namespace syncline
