// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_shift.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

/// Share of the error that is corrected at once, for each thousandth of gain. Not filtered: a filter in the direct path
/// makes the loop swing where the ESC's gain is high (a hundredfold at 400 ppm, where its speed counter nears the end).
constexpr double kSharePerPpt = 0.1;
/// For the integral, ns: its time stands well above the ESC's, so that the two loops do not fight.
constexpr double kFilterTime = 20e6;
constexpr double kIntegralTime = 7.5e9;    // divided by the drift error gain
constexpr double kMaxCorrection = 20'000;  // ns; an ESC at its slew limit is not helped by more
constexpr int kBlocksAway = 10;
constexpr double kAwayPpm = 3;

}  // namespace

BusShift::BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least)
    : target_{0, set_value, cycle_time},
      monitor_(settings, cycle_time, set_value, least),
      gate_(static_cast<double>(settings.max_valid_value)),
      control_off_(settings.control_off),
      share_(std::min(1.0, kSharePerPpt * settings.gain_ppt)),
      integral_time_(kIntegralTime / std::max(1U, settings.drift_error_gain)) {}

void BusShift::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  filtered_ = integral_ = 0;
  blocks_away_ = 0;
  last_.reset();
  gate_.start();
  anchor_ = {first_send_time, target_.nearest(first_reference_time)};
}

Nanoseconds BusShift::wanted_at(Nanoseconds host_time) const {
  return anchor_.reference_time + (host_time - anchor_.host_time);
}

std::optional<Nanoseconds> BusShift::reference_write(Nanoseconds send_time, Nanoseconds) {
  if (control_off_) return std::nullopt;
  // Counted from the real send time: a frame that leaves late carries a later time.
  if (!last_) return wanted_at(send_time);
  const auto predicted = last_->reference_time + (send_time - last_->host_time);
  const auto lag = static_cast<double>(last_->reference_time - wanted_at(last_->host_time));
  return predicted - static_cast<Nanoseconds>(std::llround(share_ * lag + integral_));
}

DcmAction BusShift::observe(const DcmObservation& observation) {
  if (!observation.reference_time) {
    monitor_.observe(observation, 0);
    monitor_.report(state_);
    return {};
  }
  // Not folded into a cycle: the clock that falls behind by whole cycles is still behind.
  const auto lag = *observation.reference_time - wanted_at(observation.send_time);
  const bool new_block = monitor_.observe(observation, lag);
  const auto verdict = gate_.judge(static_cast<double>(lag) - filtered_, monitor_.in_sync());
  if (verdict != OutlierGate::Verdict::kOutlier) {
    last_ = Reading{observation.send_time, *observation.reference_time};
    integrate(static_cast<double>(lag));
  }
  if (new_block) watch_runaway();
  monitor_.report(state_);
  state_.adjust = static_cast<Nanoseconds>(std::llround(-(share_ * static_cast<double>(lag) + integral_)));
  state_.output_sum = -integral_;
  if (!control_off_) state_.output_total += state_.adjust;
  return {};
}

void BusShift::integrate(double lag) {
  const auto cycle = static_cast<double>(target_.cycle);
  filtered_ += std::min(1.0, cycle / kFilterTime) * (lag - filtered_);
  integral_ = std::clamp(integral_ + cycle / integral_time_ * filtered_, -kMaxCorrection, kMaxCorrection);
}

/// An ESC at the end stop of its speed counter (763 ppm) falls behind for good, however slowly.
void BusShift::watch_runaway() {
  const double ppm = monitor_.drift().last_block_ppm();
  const bool away = std::abs(monitor_.filtered()) > kMaxCorrection && std::abs(ppm) > kAwayPpm &&
                    (ppm > 0) == (monitor_.filtered() > 0);
  blocks_away_ = away ? std::min(blocks_away_ + 1, kBlocksAway) : 0;
  monitor_.set_running_away(blocks_away_ >= kBlocksAway);
}

}  // namespace syncline::dc
