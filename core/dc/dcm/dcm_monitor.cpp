// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcm_monitor.h"

#include <algorithm>
#include <cmath>

#include "config/dcm_settings.h"
#include "dc/dcm/dcm_controller.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

constexpr double kShownFilterTime = 20e6;              // ns
constexpr double kDriftBelowPpm = kMostDriftPpm - 10;  // once too high, it must be clearly less again

}  // namespace

DcmMonitor::DcmMonitor(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value,
                       Nanoseconds least_set_value)
    : cycle_(cycle_time),
      valid_set_value_(set_value > 0 && set_value >= least_set_value && set_value < cycle_time),
      controls_(!settings.control_off),
      judge_(settings),
      steps_(settings.in_sync_limit),
      bus_cycle_(cycle_time) {}

void DcmMonitor::start(Nanoseconds time) {
  judge_.start(time);
  drift_.start();
  own_drift_.reset();
  steps_.start();
  bus_cycle_.start();
  start_ = time;
  error_ = 0;
  filtered_ = doubt_ = 0;
  running_away_ = drift_too_high_ = false;
  step_.reset();
  after_.reset();
  error_code_ = 0;
}

bool DcmMonitor::observe(const DcmObservation& observation, Nanoseconds error) {
  bus_cycle_.observe(observation.scheduled_time, observation.reference_time.has_value());
  step_.reset();
  bool new_drift = false;
  if (observation.reference_time) {
    read(observation, error);
    if (doubt_ == 0) new_drift = drift_.observe(observation.send_time, *observation.reference_time);
  } else {
    judge_.observe_silence(observation.send_time);
  }
  error_code_ = error_code();
  if (in_sync() && !after_) after_ = observation.send_time - start_;
  return new_drift;
}

void DcmMonitor::note_other_way() {
  steps_.look_elsewhere();
  drift_.leave_gap();
}

void DcmMonitor::read(const DcmObservation& observation, Nanoseconds error) {
  error_ = error;
  const auto reading = steps_.observe(observation.send_time, *observation.reference_time, observation.stamp_doubt);
  doubt_ = reading.doubt;
  const double seen = without_doubt(filtered_, error);
  filtered_ += std::min(1.0, static_cast<double>(cycle_) / kShownFilterTime) * (seen - filtered_);
  judge_.observe(observation.send_time, static_cast<Nanoseconds>(std::llround(filtered_)));
  // A clock that is still being led to its place changes its rate as it goes.
  if (!reading.step || !judge_.in_sync()) return;
  step_ = reading.step;
  judge_.lose();
}

double DcmMonitor::without_doubt(double expected, Nanoseconds error) const {
  const auto nearest = [&](double most) { return std::clamp(expected, most - doubt_, most); };
  const double here = nearest(static_cast<double>(error));
  if (doubt_ == 0) return here;
  // One that is later by more than half a cycle looks early in the grid.
  const double next = nearest(static_cast<double>(error + cycle_));
  return std::abs(next - expected) < std::abs(here - expected) ? next : here;
}

std::uint32_t DcmMonitor::error_code() {
  // A cause comes before its consequence.
  if (!valid_set_value_) return kDcmErrorInvalidSetValue;
  if (bus_cycle_.wrong()) return kDcmErrorBusCycleWrong;
  const auto& drift = own_drift();
  drift_too_high_ = drift.proven() && std::abs(drift.ppm()) > (drift_too_high_ ? kDriftBelowPpm : kMostDriftPpm);
  if (running_away_ || drift_too_high_) return kDcmErrorDriftTooHigh;
  // Where nothing is moved the schedule leaves its place, which is no error of the control; nor is it one that nobody
  // hears the time.
  const bool left = judge_.was_in_sync() && !judge_.in_sync() && !judge_.lost_by_silence();
  if (controls_ && left) return kDcmErrorOutOfLimit;
  return 0;
}

void DcmMonitor::lead_back() {
  if (step_) return set_led_back(true);
  if (in_sync()) set_led_back(false);
}

void DcmMonitor::set_led_back(bool led_back) {
  if (led_back == own_drift_.has_value()) return;
  if (led_back) {
    own_drift_ = drift_;
    own_drift_->leave_gap();
  } else {
    drift_ = *own_drift_;
    own_drift_.reset();
  }
}

void DcmMonitor::report(DcmState& state) const {
  state.error = error_;
  state.error_filtered = static_cast<Nanoseconds>(std::llround(filtered_));
  state.drift_ppm = own_drift().ppm();
  state.drift_half_width_ppm = own_drift().half_width_ppm();
  state.in_sync = in_sync();
  state.in_sync_after = after_;
  state.clock_step = step_;
  state.error_code = error_code_;
}

}  // namespace syncline::dc
