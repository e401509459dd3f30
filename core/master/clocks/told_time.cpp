// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/told_time.h"

#include <algorithm>

namespace syncline {
namespace {

/// More is a clock that has stepped, or a host that stood still between stamp and frame.
constexpr Nanoseconds kMostOwed = 100 * kMicrosecond;
constexpr Nanoseconds kAverage = 16;

}  // namespace

Nanoseconds ToldTime::tell(Nanoseconds believed) {
  believed_ = believed;
  return believed - owed_;
}

void ToldTime::observe(std::optional<Nanoseconds> shown) {
  if (!shown) {
    owed_ = 0;
    return;
  }
  // What the frame before it owed is paid with this one, and so the sum is by this one's error too much.
  owed_ = std::clamp(believed_ - *shown, -kMostOwed, kMostOwed);
  bias_ += (owed_ - bias_) / kAverage;
}

}  // namespace syncline
