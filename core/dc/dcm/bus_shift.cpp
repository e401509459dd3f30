// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_shift.h"

#include <algorithm>
#include <cmath>

#include "config/dcm_settings.h"

namespace syncline::dc {
namespace {

/// Share of the error that is corrected at once, for each thousandth of gain. Not filtered: a filter in the direct path
/// makes the loop swing where the ESC's gain is high (a hundredfold at 400 ppm, where its speed counter nears the end).
constexpr double kSharePerPpt = 0.1;
/// For the integral, ns: its time stands well above the ESC's, so that the two loops do not fight.
constexpr double kFilterTime = 20e6;
constexpr double kIntegralTime = 7.5e9;  // divided by the drift error gain
/// With reset values (0x0930, 0x0935) an ESC runs 16.7 ppm faster for each us that it is told to be behind, and makes
/// what it is told for so many cycles its own rate.
constexpr double kEscGain = 16.7e-9, kEscCycles = 4096;  // 1/ns
/// Two integrals and the clock itself do not swing while gain x share x (share x integral time + the ESC's) is above 1;
/// there is noise, too. What the share is ahead has to be some times more than the filters are behind, ours, and the
/// ESC's of 64 cycles (0x0934): with half more only, a clock that comes back after an outage went as far past its place
/// as it had been away from it.
constexpr double kLoopReserve = 2.5, kFilterCycles = 400, kOurFilter = 2 * kFilterTime;
/// For the same reason the share is so small that the ESC's filter is behind by no more than this of a radian where the
/// loop is as fast as it gets: from 2 ms on with a project's defaults.
constexpr double kEscFilterCycles = 64, kMostBehind = 0.5;
constexpr double kMaxCorrection = 20'000;  // ns; an ESC at its slew limit is not helped by more
constexpr Nanoseconds kStandstill = kSecond / 2;
constexpr int kBlocksAway = 10;
constexpr int kKnown = 100;  // readings before an outlier can be told
constexpr double kAwayPpm = 3;

/// ns. Whatever the gains are set to: with less time the clock would swing, by tens of microseconds.
double shortest_integral_time(double share, Nanoseconds cycle_time) {
  const auto cycle = static_cast<double>(cycle_time);
  const double beside_esc = kLoopReserve / (kEscGain * share) - kEscCycles * cycle;
  return std::max(beside_esc, kFilterCycles * cycle + kOurFilter) / share;
}

/// Slaves are about eight cycles behind a clock that changes its rate: kDcxFastestPpm is that for a window of 127 ns
/// and 1 ms. From further away than this a clock would need seconds, and they leave their window with it.
constexpr double kLittleAway = 16'000;  // ns
double borne_at_once(Nanoseconds cycle_time) {
  const auto cycle = static_cast<double>(std::max(cycle_time, kMillisecond));
  return kDcxFastestPpm * 1e-6 * static_cast<double>(kMillisecond) / cycle / kEscGain;
}

double share_of(std::uint32_t gain_ppt, Nanoseconds cycle_time) {
  const double most = kMostBehind / (kEscGain * kEscFilterCycles * static_cast<double>(cycle_time));
  return std::min(std::clamp(kSharePerPpt * gain_ppt, kSharePerPpt, 1.0), most);
}

}  // namespace

BusShift::BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least)
    : target_{0, set_value, cycle_time},
      monitor_(settings, cycle_time, set_value, least),
      way_(cycle_time, settings.in_sync_limit / ChangedWay::kPartOfLimit),
      forecast_(static_cast<double>(settings.max_valid_value)),
      limit_(settings.in_sync_limit),
      share_(share_of(settings.gain_ppt, cycle_time)),
      borne_(borne_at_once(cycle_time)),
      integral_time_(std::max(kIntegralTime / std::max(1U, settings.drift_error_gain),
                              shortest_integral_time(share_, cycle_time))) {}

void BusShift::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  way_.start();
  filtered_ = integral_ = 0;
  blocks_away_ = 0;
  working_off_.reset();
  known_ = 0;
  lag_ = 0;
  heard_ = 0;
  forecast_.start();
  anchor_ = {first_send_time, target_.nearest(first_reference_time)};
}

Nanoseconds BusShift::wanted_at(Nanoseconds host_time) const {
  return anchor_.reference_time + (host_time - anchor_.host_time) + way_.offset();
}

Nanoseconds BusShift::lag_of(const DcmObservation& observation) const {
  return *observation.reference_time - wanted_at(observation.send_time);
}

void BusShift::note_other_way() {
  monitor_.note_other_way();
  if (monitor_.in_sync()) way_.note();
}

std::optional<Nanoseconds> BusShift::reference_write(Nanoseconds send_time, Nanoseconds) {
  // Counted from the real send time: a frame that leaves late carries a later time.
  const auto forecast = forecast_.at(send_time);
  if (!forecast) return wanted_at(send_time + forecast_.usual_way());
  return *forecast - static_cast<Nanoseconds>(std::llround(taken_back() + integral_));
}

double BusShift::taken_back() const {
  const double share = share_ * lag_;
  return working_off_ && working_off_->slowly ? std::clamp(share, -borne_, borne_) : share;
}

void BusShift::note_reading(const DcmObservation& observation) {
  constexpr Nanoseconds kSilence = 100 * kMillisecond;
  // Which may be its stamp's alone.
  if (observation.stamp_doubt > limit_ / 4) return;
  const bool silent = heard_ != 0 && observation.send_time - heard_ > kSilence;
  if (monitor_.in_sync() || heard_ != 0) heard_ = observation.send_time;
  if (!silent) return;
  const auto lag = static_cast<double>(lag_of(observation));
  if (std::abs(lag) > kLittleAway || std::abs(share_ * lag) <= borne_) return;
  forecast_.forget();
  filtered_ = lag;
  working_off_ = WorkingOff{std::abs(lag), 0, true};
}

DcmAction BusShift::observe(const DcmObservation& observation) {
  DcmAction action;
  if (observation.reference_time) {
    // Not folded into a cycle: the clock that falls behind by whole cycles is still behind.
    const bool another_way = way_.take(lag_of(observation) + way_.offset() - std::llround(filtered_));
    note_reading(observation);
    auto lag = lag_of(observation);
    const bool new_block = monitor_.observe(observation, lag);
    monitor_.lead_back();
    if (monitor_.step()) lag = begin_anew(observation);
    action.write_again = take(observation, lag) == OutlierGate::Verdict::kOutlier || another_way;
    if (new_block) watch_runaway();
    state_.adjust = static_cast<Nanoseconds>(std::llround(-(taken_back() + integral_)));
    state_.output_sum = -integral_;
    state_.output_total += state_.adjust;
  } else {
    monitor_.observe(observation, 0);
  }
  monitor_.report(state_);
  return action;
}

OutlierGate::Verdict BusShift::take(const DcmObservation& observation, Nanoseconds lag) {
  // While the clock is on its way to its place there is no telling an outlier.
  const bool settled = monitor_.in_sync() || (known_ >= kKnown && std::abs(filtered_) < static_cast<double>(limit_));
  const auto verdict = forecast_.take(observation, static_cast<double>(lag) - filtered_, settled);
  lag_ = verdict == OutlierGate::Verdict::kOutlier ? filtered_ : monitor_.without_doubt(filtered_, lag);
  known_ = std::min(known_ + 1, kKnown);
  integrate(lag_);
  return verdict;
}

bool BusShift::observe_second_write(const DcmObservation& observation) {
  if (!observation.reference_time) return false;
  return forecast_.take_again(observation, static_cast<double>(lag_of(observation)) - filtered_);
}

/// The reference clock has stepped: from where it is now it is led to the nearest place in the grid. Whole cycles are
/// not taken back, for that would take a second for each.
Nanoseconds BusShift::begin_anew(const DcmObservation& observation) {
  const auto time = *observation.reference_time - (observation.send_time - observation.scheduled_time);
  anchor_ = {observation.scheduled_time, target_.nearest(time)};
  way_.start();
  forecast_.forget();
  const auto lag = lag_of(observation);
  filtered_ = static_cast<double>(lag);
  working_off_ = WorkingOff{std::abs(filtered_), 0, false};
  return lag;
}

void BusShift::integrate(double lag) {
  const auto cycle = static_cast<double>(target_.cycle);
  filtered_ += std::min(1.0, cycle / kFilterTime) * (lag - filtered_);
  if (work_off_step()) return;
  integral_ = std::clamp(integral_ + cycle / integral_time_ * filtered_, -kMaxCorrection, kMaxCorrection);
}

/// A step has taught nothing about the drift. What no longer gets smaller is not the step: then it is the integral that
/// holds the clock where it is, and must go on.
bool BusShift::work_off_step() {
  constexpr double kSmaller = 0.98;
  const double left = std::abs(filtered_);
  const bool slowly = working_off_ && working_off_->slowly;
  if (!working_off_ || left <= (slowly ? borne_ / share_ : static_cast<double>(limit_))) {
    working_off_.reset();
    return false;
  }
  if (left <= kSmaller * working_off_->left) working_off_ = WorkingOff{left, 0, slowly};
  working_off_->stands_for += target_.cycle;
  if (working_off_->stands_for > kStandstill) working_off_.reset();
  return working_off_.has_value();
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
