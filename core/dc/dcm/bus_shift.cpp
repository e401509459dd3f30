// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_shift.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

/// Well below the ESC loop's 84 ms; for the integral only, since a filter in the direct path makes the loop
/// swing where the ESC's gain is high (a hundredfold at 400 ppm, where its speed counter nears the end).
constexpr double kFilterTime = 20e6;
/// In which the integral takes over an error; well above the ESC's, so that the two loops do not fight.
constexpr double kAcquireIntegralTime = 500e6;
constexpr double kTrackIntegralTime = 2.5e9;
/// Share of the error that is corrected at once while in sync. Short cycles bring the ESC more messages: its
/// loop learns faster, and has to be led faster.
constexpr double kMinTrackShare = 0.2;
constexpr double kMaxTrackShare = 0.5;
constexpr double kTrackShareTime = 200e3;
constexpr double kMaxCorrection = 20'000;  // ns; an ESC at its slew limit is not helped by more
constexpr Nanoseconds kFreshCycles = 4;    // a prediction from an older reading is worth less than none
constexpr int kBlocksAway = 10;
constexpr double kAwayPpm = 3;

}  // namespace

BusShift::BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value)
    : target_{0, set_value, cycle_time}, monitor_(settings, cycle_time, set_value) {}

void BusShift::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  filtered_ = integral_ = 0;
  blocks_away_ = 0;
  tracking_ = false;
  last_.reset();
  // Nearest place in the grid: the clock is never asked to jump.
  anchor_.host_time = first_send_time;
  anchor_.reference_time = first_reference_time -
                           wrap_to_half(first_reference_time - (target_.base - target_.set_value), target_.cycle);
}

Nanoseconds BusShift::wanted_at(Nanoseconds host_time) const {
  return anchor_.reference_time + (host_time - anchor_.host_time);
}

bool BusShift::predicts(Nanoseconds send_time) const {
  return tracking_ && last_ && send_time - last_->host_time <= kFreshCycles * target_.cycle;
}

double BusShift::track_share() const {
  return std::clamp(kTrackShareTime / static_cast<double>(target_.cycle), kMinTrackShare, kMaxTrackShare);
}

std::optional<Nanoseconds> BusShift::reference_write(Nanoseconds send_time, Nanoseconds) {
  // Counted from the real send time: a frame that leaves late carries a later time.
  if (!predicts(send_time)) return wanted_at(send_time) - static_cast<Nanoseconds>(std::llround(integral_));
  const auto now = last_->reference_time + (send_time - last_->host_time);
  const auto lag = static_cast<double>(last_->reference_time - wanted_at(last_->host_time));
  return now - static_cast<Nanoseconds>(std::llround(track_share() * lag + integral_));
}

DcmAction BusShift::observe(const DcmObservation& observation) {
  if (!observation.reference_time) {
    monitor_.observe(observation, 0);
    monitor_.report(state_);
    return {};
  }
  last_ = Reading{observation.send_time, *observation.reference_time};
  // Not folded into a cycle: the clock that falls behind by whole cycles is still behind.
  const auto lag = *observation.reference_time - wanted_at(observation.send_time);
  const bool new_block = monitor_.observe(observation, lag);
  correct(static_cast<double>(lag));
  if (new_block) watch_runaway();
  monitor_.report(state_);
  state_.adjust = static_cast<Nanoseconds>(std::llround(-integral_));
  return {};
}

void BusShift::correct(double lag) {
  const bool tracking = monitor_.in_sync();
  // What the share no longer corrects is handed to the integral: the clock must not feel the change.
  if (tracking && !tracking_) integral_ += (1 - track_share()) * filtered_;
  if (!tracking && tracking_) integral_ -= (1 - track_share()) * filtered_;
  tracking_ = tracking;
  const auto cycle = static_cast<double>(target_.cycle);
  filtered_ += std::min(1.0, cycle / kFilterTime) * (lag - filtered_);
  const double integral_time = tracking ? kTrackIntegralTime : kAcquireIntegralTime;
  integral_ = std::clamp(integral_ + cycle / integral_time * filtered_, -kMaxCorrection, kMaxCorrection);
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
