// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/outlier_gate.h"
#include "support/types.h"

namespace syncline::dc {

/// What the reference clock shows at a host time, from the readings of all cycles: a line whose place and rate follow
/// them slowly, so that a single send stamp that is wrong by some ten microseconds does not go on to those who are told
/// the line (slaves in front of the reference clock, clocks that return). Values only, allocates nothing; one thread.
class ReferenceLine {
 public:
  /// A pair that is known to be right; the rate is unknown.
  void start(Nanoseconds host_time, Nanoseconds reference_time);
  /// A reading: system time of the reference clock when the frame passed that was sent at this host time. Later than
  /// the one before.
  void observe(Nanoseconds host_time, Nanoseconds reference_time);
  /// Another clock leads, or the same again: it may be elsewhere, and runs as fast as the one before.
  void start_place_anew() { place_known_ = false; }
  /// `ppm`: rate of the reference clock against the host as it is known over seconds; it counts when the last reading
  /// is longer ago than a few cycles.
  [[nodiscard]] Nanoseconds at(Nanoseconds host_time, double ppm) const;

 private:
  static constexpr double kLimit = 3'000;  // ns; of a stamp that is worse, as nMaxValidVal's default

  Nanoseconds host_ = 0, reference_ = 0;
  double fraction_ = 0;  // ns, of reference_
  double rate_ = 0;      // the reference clock's less the host's, ns a ns
  int readings_ = 0;
  bool place_known_ = true;
  OutlierGate gate_{kLimit};
};

}  // namespace syncline::dc
