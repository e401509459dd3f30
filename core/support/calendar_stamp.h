// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/clock.h"

namespace syncline {

/// Turns the kernel's stamps of frames, which are of the calendar clock, into times of our own. Calendar and own clock
/// are held against each other at each stamp, so that a calendar that is set while we run is noticed at once; but the
/// difference is only taken over when it has really changed, because one of three readings may be interrupted. One
/// thread.
class CalendarStamp {
 public:
  explicit CalendarStamp(const Clock& clock);
  /// Nothing when the stamp lies outside `earliest`..now: the calendar was set between the stamp and now.
  [[nodiscard]] std::optional<Nanoseconds> to_clock(Nanoseconds calendar, Nanoseconds earliest);

 private:
  struct Pair {
    Nanoseconds ahead = 0;  // calendar less own clock
    Nanoseconds way = 0;    // between the readings of the own clock
    Nanoseconds now = 0;
  };
  [[nodiscard]] Pair read() const;

  const Clock& clock_;
  Nanoseconds ahead_ = 0;
};

}  // namespace syncline
