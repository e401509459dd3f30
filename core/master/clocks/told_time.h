// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "support/types.h"

namespace syncline {

/// What slaves in front of the reference clock are told in its place, because the frame reaches them first: what the
/// master believes that the clock will show. By how much that was wrong comes back with the frame, as the clock puts
/// its own time into the same datagram. The next frame makes that good, so that what a slave's control loop sums up
/// (ESC data sheet I, 9.1.4) stays that of the reference clock: neither the jitter of send stamps nor the time from the
/// stamp to the wire remains in it. Times in ns. Allocates nothing; the cyclic thread.
class ToldTime {
 public:
  /// In the cyclic frame that is being sent, out of what the master believes.
  [[nodiscard]] Nanoseconds tell(Nanoseconds believed);
  /// For frames between two of them, of which nobody waits for the answer: without what remains on average.
  [[nodiscard]] Nanoseconds tell_between(Nanoseconds believed) const { return believed - bias_; }
  /// What the clock showed as that frame passed it; nothing when it is not known.
  void observe(std::optional<Nanoseconds> shown);

 private:
  Nanoseconds believed_ = 0;
  Nanoseconds owed_ = 0;  // by so much was told too much
  Nanoseconds bias_ = 0;  // of what is believed, on average
};

}  // namespace syncline
