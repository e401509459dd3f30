// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>

#include "trace/held_series.h"

namespace syncline {

/// How many a second a count counts: what it counted in the second before each moment. It changes where the count does
/// and a second later, and is known while the count is. A count that goes back was cleared: what it shows came since.
class RateSeries {
 public:
  static constexpr Nanoseconds kWindow = kSecond;

  /// What the count has told since the last time. Always of the same one.
  void extend(const HeldSeries& count);
  [[nodiscard]] const HeldSeries& rates() const { return rates_; }

 private:
  void age(Nanoseconds until);
  void take(Nanoseconds time, float value);

  HeldSeries rates_{1U << 15};
  struct Counted {
    Nanoseconds time = 0;
    double count = 0;
  };
  std::deque<Counted> recent_;  // not older than the window
  double sum_ = 0;              // of these
  float last_ = 0;
  bool known_ = false;
  Nanoseconds done_ = INT64_MIN;
};

}  // namespace syncline
