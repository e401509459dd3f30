// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "support/types.h"

namespace syncline::dc {

/// By how much readings of the reference clock are elsewhere because frames go another way to it than before: slaves in
/// front of it have come or gone, or another clock leads. No clock has moved, and so none is to be moved by that; its
/// place in the SYNC grid, as it was asked for, it is led to slowly. Times in ns. Allocates nothing; one thread.
class ChangedWay {
 public:
  /// Of the limit of being in sync: a way that is longer by no more is an error like any other, which a loop takes
  /// back.
  static constexpr Nanoseconds kPartOfLimit = 4;
  /// `least`: ways that are longer by no more do not count, because single readings are off by so much.
  ChangedWay(Nanoseconds cycle, Nanoseconds least);
  void start();
  /// The way may be another one from the next reading on.
  void note();
  /// One cycle with a reading that is so far `off` where it was expected, were the way that of the beginning. True when
  /// it is the first by another way, so that what its frame has told the clock was wrong.
  bool take(Nanoseconds off);
  /// By so much readings are later than by the way of the beginning, less what has been led back.
  [[nodiscard]] Nanoseconds offset() const;

 private:
  void lead_back();
  [[nodiscard]] Nanoseconds median() const;

  static constexpr std::size_t kReadings = 8;  // their median counts: single stamps are wrong by tens of microseconds
  Nanoseconds most_, least_;
  double step_;  // of leading back, a cycle
  double offset_ = 0;
  double before_ = 0;  // offset_ when the way may have changed
  std::array<Nanoseconds, kReadings> off_{};
  std::size_t taken_ = kReadings;  // readings since then
};

}  // namespace syncline::dc
