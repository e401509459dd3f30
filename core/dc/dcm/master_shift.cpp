// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/master_shift.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "config/dcm_settings.h"

namespace syncline::dc {
namespace {

constexpr double kPull = 0.1;      // share of the phase that one cycle takes back
constexpr double kMaxStep = 0.02;  // of the cycle

PhaseTracker::Gains gains_of(const DcmSettings& settings) {
  const double gain = settings.gain_ppt * 1e-3;
  return {gain, settings.drift_error_gain * gain * gain / 4};
}

}  // namespace

std::optional<double> loop_frequency(const DcmSettings& settings, Nanoseconds cycle_time) {
  if (!moves_host_timer(settings.mode) || settings.control_off || cycle_time <= 0) return std::nullopt;
  // Of s^2 + phase s + drift, in cycles.
  const auto gains = gains_of(effective_dcm_settings(settings));
  const double swing = gains.drift - gains.phase * gains.phase / 4;
  if (swing <= 0) return std::nullopt;
  return std::sqrt(swing) / (2 * std::numbers::pi) / (static_cast<double>(cycle_time) / 1e9);
}

MasterShift::MasterShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least)
    : moves_timer_(!settings.control_off && settings.mode != DcmMode::kMasterShiftByApp),
      target_{0, set_value, cycle_time},
      monitor_(settings, cycle_time, set_value, least),
      tracker_(gains_of(settings), static_cast<double>(cycle_time), static_cast<double>(settings.max_valid_value)),
      way_(cycle_time, settings.in_sync_limit / ChangedWay::kPartOfLimit) {}

void MasterShift::start(Nanoseconds base, Nanoseconds, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  tracker_.start();
  way_.start();
  state_ = {};
  last_scheduled_.reset();
}

DcmAction MasterShift::observe(const DcmObservation& observation) {
  const auto error = observation.reference_time ? error_of(observation) : 0;
  monitor_.observe(observation, error);
  follow(observation);
  if (monitor_.step()) {
    tracker_.forget_phase();
    way_.start();
  }
  // Without a valid reading it coasts: the drift is known, and the phase as far as it was.
  if (observation.reference_time) tracker_.update(monitor_.without_doubt(tracker_.phase(), error));
  const auto cycle = static_cast<double>(target_.cycle);
  const double wanted = -(tracker_.drift() + kPull * tracker_.phase());
  const double adjust = std::clamp(wanted, -kMaxStep * cycle, kMaxStep * cycle);
  monitor_.report(state_);
  state_.adjust = static_cast<Nanoseconds>(std::llround(adjust));
  state_.output_sum = -tracker_.drift();
  if (!moves_timer_) return {};
  state_.output_total += state_.adjust;
  return {state_.adjust, {}};
}

void MasterShift::note_other_way() {
  monitor_.note_other_way();
  if (monitor_.in_sync()) way_.note();
}

Nanoseconds MasterShift::error_of(const DcmObservation& observation) {
  const auto error = target_.error(observation);
  (void)way_.take(error - std::llround(monitor_.filtered()));
  return error - way_.offset();
}

/// What the schedule was really moved by, whoever did it, and cycles that were left out.
void MasterShift::follow(const DcmObservation& observation) {
  if (last_scheduled_) {
    const auto passed = observation.scheduled_time - *last_scheduled_;
    const auto cycles = std::max<Nanoseconds>(1, (passed + target_.cycle / 2) / target_.cycle);
    tracker_.advance(static_cast<double>(cycles), static_cast<double>(passed - cycles * target_.cycle));
  }
  last_scheduled_ = observation.scheduled_time;
}

}  // namespace syncline::dc
