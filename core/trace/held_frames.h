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
  /// Send stamps are wrong by so much on hosts that hold no frames up.
  static constexpr Nanoseconds kRemarkable = 10 * kMicrosecond;
  /// What was sent within it is one sum.
  static constexpr Nanoseconds kSpan = 5 * kMillisecond;

  /// Sent at `time` and `by` later than usual, ns; nothing below kRemarkable. Times ascend.
  void note(Nanoseconds time, Nanoseconds by);
  /// By how much those sent from `from` to `to` were late, all together, ns; of the spans that begin then.
  [[nodiscard]] Nanoseconds sum(Nanoseconds from, Nanoseconds to) const;

 private:
  struct Span {
    Nanoseconds begin = 0, sum = 0;
  };
  std::array<Span, 128> spans_{};
  std::size_t latest_ = 0;
};

}  // namespace syncline
