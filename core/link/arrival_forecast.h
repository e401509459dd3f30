// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline {

/// When the next frame of a master is to be expected that sends in cycles: whoever is awake then answers as a slave
/// does, at once, and not when a host has woken him up. Values only; one thread.
class ArrivalForecast {
 public:
  /// Frames that follow each other by less belong to one cycle.
  static constexpr Nanoseconds kTogether = 60 * kMicrosecond;

  /// A frame has come at `time`.
  void arrived(Nanoseconds time);
  struct Window {
    Nanoseconds from = 0, until = 0;
  };
  /// The window in which the next cycle's first frame is to be expected, with the time in front of it that a timer
  /// takes to wake somebody up; no more than a tenth of the cycle wide. Nothing where frames come at no fixed distance,
  /// or by more than a window has room for off their places.
  [[nodiscard]] std::optional<Window> next() const;

 private:
  void begin_anew(Nanoseconds period);

  std::optional<Nanoseconds> last_, cycle_begin_;  // the last frame, and the first one of its cycle
  double period_ = 0, spread_ = 0;                 // ns; of the distance between cycles, and how far off it is
  unsigned regular_ = 0;                           // cycles in a row that came about when they should
};

}  // namespace syncline
