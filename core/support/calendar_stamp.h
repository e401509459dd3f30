// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "support/types.h"

namespace syncline {

class Clock;

/// CLOCK_REALTIME, ns since 1970.
[[nodiscard]] Nanoseconds calendar_now();

/// Turns the kernel's stamps of frames, which are of the calendar clock, into times of our own. Calendar and own clock
/// are held against each other at each stamp, so that a calendar that is set while we run is noticed at once; but the
/// difference is only taken over when it has really changed, because one of three readings may be interrupted. Frames
/// that were stamped before the calendar was set, and are read after it, are known by when they can have come. One
/// thread.
class CalendarStamp {
 public:
  using Calendar = std::function<Nanoseconds()>;
  explicit CalendarStamp(const Clock& clock, Calendar calendar = calendar_now);
  /// Nothing when the stamp lies outside `earliest`..now by the calendar as it is and as it was, or inside by both.
  [[nodiscard]] std::optional<Nanoseconds> to_clock(Nanoseconds calendar, Nanoseconds earliest);

 private:
  struct Pair {
    Nanoseconds ahead = 0;  // calendar less own clock
    Nanoseconds way = 0;    // between the readings of the own clock
    Nanoseconds now = 0;
  };
  /// The calendar was set after `begin` and before `end`, both of the own clock, and was so much ahead until then.
  struct Setting {
    Nanoseconds ahead = 0, begin = 0, end = 0;
  };
  [[nodiscard]] Pair read() const;
  /// False: the calendar was set, and the reading is too slow to say by how much.
  bool notice(const Pair& pair);

  const Clock& clock_;
  Calendar calendar_;
  Nanoseconds ahead_ = 0, confirmed_ = 0;
  std::optional<Setting> last_{};
};

/// The same of frames that come and are read in one order. One thread.
class ArrivalStamp {
 public:
  explicit ArrivalStamp(const Clock& clock, CalendarStamp::Calendar calendar = calendar_now)
      : clock_(clock), stamps_(clock, std::move(calendar)) {}
  /// On the own clock; now, when the calendar was set so that it cannot be known.
  [[nodiscard]] Nanoseconds to_clock(Nanoseconds calendar);

 private:
  const Clock& clock_;
  CalendarStamp stamps_;
  Nanoseconds last_ = 0;
};

}  // namespace syncline
