// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "support/types.h"

namespace syncline {

/// The largest magnitude at which a value has stayed for as long as the verdict on the master is patient with one that
/// is over its limit (dc/dcm/sync_judge.h): over the limit exactly where that verdict is lost by it. A single tail of
/// the host's jitter is none.
class LastingMagnitude {
 public:
  struct Reading {
    Nanoseconds time = 0;  // host clock: by then it had lasted
    std::int64_t magnitude = 0;
  };

  /// Values in their order; a cycle without one interrupts nothing.
  void add(Nanoseconds time, std::int64_t magnitude);
  void clear();
  /// Nothing before the first values have come for so long.
  [[nodiscard]] const std::optional<Reading>& largest() const { return largest_; }
  /// Part of the limit that it leaves, negative when it was exceeded; nothing without both.
  [[nodiscard]] std::optional<double> margin(std::int64_t limit) const;

 private:
  /// Since then no value was smaller.
  struct Level {
    Nanoseconds since = 0;
    std::int64_t magnitude = 0;
  };
  std::deque<Level> levels_;  // rising, the later the larger
  std::optional<Reading> largest_;
};

}  // namespace syncline
