// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/outlier_gate.h"

namespace syncline::dc {

/// Where the schedule is in the SYNC grid, and how fast it drifts there: a Kalman filter over both, told what the
/// schedule was moved by. It begins like a straight line laid through all readings, and ends with the fixed gains of
/// a second-order loop, which are the settings'. Because it knows what was moved, how hard the controller pulls does
/// not enter its stability. Readings that stay on one side of what is expected say that the rate is another one; then
/// it begins anew as far as they are off, where the settled gains would take many seconds at cycles of some
/// milliseconds.
class PhaseTracker {
 public:
  struct Gains {
    double phase;  // of the surprise, in a settled cycle: nCtlGain
    double drift;  // the same, for the drift: nCtlDriftErrorGain * phase^2 / 4
  };
  PhaseTracker(Gains settled, double cycle_ns, double max_valid_ns);
  void start();
  /// The phase is another one: a clock has stepped. The drift is kept until the readings say otherwise.
  void forget_phase();
  /// `cycles` have passed, in which the schedule was moved by `moved` ns in all.
  void advance(double cycles, double moved);
  /// A reading of the phase, ns. False when it was no valid one.
  bool update(double phase);

  [[nodiscard]] double phase() const { return phase_; }  // ns, within half a cycle
  [[nodiscard]] double drift() const { return drift_; }  // ns a cycle
  [[nodiscard]] bool settled() const { return readings_ >= kTrusted; }

 private:
  static constexpr int kTrusted = 100;
  [[nodiscard]] double wrapped(double value) const;
  void doubt_rate(double surprise);

  Gains settled_;
  double cycle_, max_valid_;
  OutlierGate gate_;
  double phase_ = 0, drift_ = 0;
  double p11_ = 0, p12_ = 0, p22_ = 0;  // covariance, in units of the readings' variance
  double lean_ = 0;                     // mean of the last surprises, ns,
  double usual_lean_ = 0, stray_ = 0;   // how large it is at other times, and how far one is off it
  int readings_ = 0;
};

}  // namespace syncline::dc
