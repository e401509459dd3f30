// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "support/types.h"

namespace syncline {

/// By how much frames came back later than frames do (CycleSample::stamp_doubt_ns) in the last half second and more,
/// for whoever asks what that has done. Values only, one thread.
class HeldFrames {
 public:
  /// Send stamps are wrong by so much now and then on hosts that hold no frames up, and by no more than the second;
  /// but not of kInARow frames one behind the other.
  static constexpr Nanoseconds kRemarkable = 10 * kMicrosecond, kBeyondStamps = 75 * kMicrosecond;
  static constexpr int kInARow = 3;
  /// What was sent within it is one sum.
  static constexpr Nanoseconds kSpan = 5 * kMillisecond;

  /// Of each frame: sent at `time`, and came back `by` later than usual, ns. Times ascend. True: it was held up.
  bool note(Nanoseconds time, Nanoseconds by);
  /// By how much those sent from `from` to `to` were late, all together, ns; of the spans that begin then.
  [[nodiscard]] Nanoseconds sum(Nanoseconds from, Nanoseconds to) const;

 private:
  struct Span {
    Nanoseconds begin = 0, sum = 0;
  };
  void add(Nanoseconds time, Nanoseconds by);

  std::array<Span, 128> spans_{};
  int in_a_row_ = 0;
  Nanoseconds not_sure_ = 0;  // of the row at hand
  std::size_t latest_ = 0;
};

}  // namespace syncline
