// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dc/dcm/bus_cycle_check.h"
#include "dc/dcm/clock_step_detector.h"
#include "dc/dcm/drift_estimator.h"
#include "dc/dcm/sync_judge.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

struct DcmObservation;
struct DcmState;

/// What every controller says about its loop, whatever it moves: filtered error, drift, in sync or not,
/// and the error code.
class DcmMonitor {
 public:
  DcmMonitor(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least_set_value);
  void start(Nanoseconds time);
  /// One cycle; `error` of the schedule in the SYNC grid, ns. Without a reference time the error is not read.
  /// True when a new reading of the drift is there.
  bool observe(const DcmObservation& observation, Nanoseconds error);
  /// Frames may go another way to the clock that is read, or another one is: that is no step of it, nor drift.
  void note_other_way();
  /// The reference clock moves away although it is told to come.
  void set_running_away(bool running_away) { running_away_ = running_away; }
  /// Behind observe(), by who leads the clock to its place: after a step, until it is there, the rate at which it goes
  /// is not its own, and the one from before is shown.
  void lead_back();
  void report(DcmState& state) const;

  /// Behind observe(), the error of that reading as it agrees best with what was `expected`, ns: a frame that was held
  /// up on its way makes it look larger than it is, by no more than it came back later.
  [[nodiscard]] double without_doubt(double expected, Nanoseconds error) const;
  /// Error without the noise of single stamps (20 ms), ns.
  [[nodiscard]] double filtered() const { return filtered_; }
  [[nodiscard]] bool in_sync() const { return judge_.in_sync() && error_code_ == 0; }
  /// As measured, also of a clock that is led back.
  [[nodiscard]] const DriftEstimator& drift() const { return drift_; }
  /// By how much the reference clock has stepped, when this cycle made it sure.
  [[nodiscard]] std::optional<Nanoseconds> step() const { return step_; }

 private:
  void read(const DcmObservation& observation, Nanoseconds error);
  [[nodiscard]] std::uint32_t error_code();
  void set_led_back(bool led_back);
  [[nodiscard]] const DriftEstimator& own_drift() const { return own_drift_ ? *own_drift_ : drift_; }

  Nanoseconds cycle_;
  bool valid_set_value_;
  bool controls_;
  SyncJudge judge_;
  DriftEstimator drift_;
  std::optional<DriftEstimator> own_drift_;  // from before the step
  ClockStepDetector steps_;
  BusCycleCheck bus_cycle_;
  Nanoseconds start_ = 0, error_ = 0;
  double filtered_ = 0;
  double doubt_ = 0;  // ns, of the last reading, where that says nothing by itself
  bool running_away_ = false, drift_too_high_ = false;
  std::optional<Nanoseconds> step_, after_;
  std::uint32_t error_code_ = 0;
};

}  // namespace syncline::dc
