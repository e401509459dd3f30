// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dc/dcm/changed_way.h"
#include "dc/dcm/dcm_controller.h"
#include "dc/dcm/dcm_monitor.h"
#include "dc/dcm/phase_error.h"
#include "dc/dcm/write_forecast.h"

namespace syncline {
struct DcmSettings;
}  // namespace syncline

namespace syncline::dc {

/// The reference clock follows the host: each frame carries to it the time that it ought to be when the frame
/// passes. The ESC's own control loop moves the clock; an outer integral takes away the standing error that
/// this loop needs until it has learned the drift.
///
/// What is written is the forecast of its time (WriteForecast) less a share of the error. For the error that is taken
/// back an outlier does not count.
class BusShift final : public DcmController {
 public:
  BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least = 0);
  void start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) override;
  std::optional<Nanoseconds> reference_write(Nanoseconds send_time, Nanoseconds scheduled_time) override;
  DcmAction observe(const DcmObservation& observation) override;
  bool observe_second_write(const DcmObservation& observation) override;
  void note_other_way() override;
  [[nodiscard]] const DcmState& state() const override { return state_; }

 private:
  struct Reading {
    Nanoseconds host_time = 0, reference_time = 0;
  };
  /// A step of the clock; or how far it went while nobody heard of it.
  struct WorkingOff {
    double left = 0;  // of the error, ns
    Nanoseconds stands_for = 0;
    bool slowly = false;  // so that those who follow the clock stay within their window
  };
  [[nodiscard]] Nanoseconds wanted_at(Nanoseconds host_time) const;
  /// Of an observation with a reading.
  [[nodiscard]] Nanoseconds lag_of(const DcmObservation& observation) const;
  /// What is taken back at once of the error, ns.
  [[nodiscard]] double taken_back() const;
  /// A reading: the first one for a while may find the clock a little away, which is led back slowly then.
  void note_reading(const DcmObservation& observation);
  [[nodiscard]] Nanoseconds begin_anew(const DcmObservation& observation);
  OutlierGate::Verdict take(const DcmObservation& observation, Nanoseconds lag);
  void integrate(double lag);
  /// One cycle; true as long as the error is that of the step.
  [[nodiscard]] bool work_off_step();
  void watch_runaway();

  PhaseTarget target_;
  DcmMonitor monitor_;
  DcmState state_;
  ChangedWay way_;
  Reading anchor_;  // host time and what the reference clock is to show then
  double lag_ = 0;  // behind (< 0) or ahead of the place in the grid, without outliers, ns
  WriteForecast forecast_;
  Nanoseconds limit_;     // in sync
  double share_;          // of the error that is corrected at once
  double borne_;          // ns that may be corrected at once, and those who follow the clock do not notice
  double integral_time_;  // ns
  double filtered_ = 0, integral_ = 0;
  Nanoseconds heard_ = 0;  // host clock; of the last reading, since the clock was in its place for the first time
  int blocks_away_ = 0, known_ = 0;
  std::optional<WorkingOff> working_off_;
};

}  // namespace syncline::dc
