// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcx.h"

#include <algorithm>
#include <cmath>

#include "config/dcm_settings.h"
#include "dc/clock_registers.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

/// Slaves follow a changed rate a number of cycles behind. In longer ones than this they are farther behind and may be
/// farther off while it changes, by the square of the length, so all that changes it takes its time.
constexpr double kUsualCycle = 1e6;  // ns
/// ns in which what is left is gone: the way ends slowly.
constexpr double kApproach = 0.6e9;
/// ns that are written for each ppm of another rate. An ESC takes some 60 ns for one at once, and what is written for
/// long it makes its own rate: without the rate in the loop it would come by as fast as it could get.
constexpr double kPushPerPpm = 120;
/// The loop of a substitute makes it its own rate 16 times as fast (0x0935 of those who follow).
constexpr double kOfSubstitute = 0.125;
constexpr double kRateFilter = 0.1e9;  // ns
constexpr double kMostPpm = 200;       // a reading that moved more has stepped, and says nothing of the rate
constexpr double kTogetherPpm = 2;
constexpr Nanoseconds kMeasured = 500 * kMillisecond;  // the rate is known by then
constexpr double kNear = 3'000;                        // ns: only what stays there is learned
constexpr double kDcxIntegralTime = 2.5e9;             // ns
constexpr double kDcxMaxIntegral = 5'000;              // ns
constexpr double kPushChange = 2e-6;  // ns a ns: a rate that changes at once takes slaves out of their window
constexpr double kBrake = 0.8 * kPushChange / kPushPerPpm;  // ppm a ns: less than the push can change
constexpr double kDcxMaxCorrection = 600;                   // ns: moves an ESC by some 10 ppm at once
constexpr std::uint32_t kLeastGain = 20;                    // ppt: the clock that the host follows is being moved
constexpr Nanoseconds kPatience = kSecond;

DcmSettings for_host(DcmSettings settings) {
  settings.gain_ppt = std::max(settings.gain_ppt, kLeastGain);
  return settings;
}

}  // namespace

Dcx::Dcx(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least)
    : control_off_(settings.control_off),
      cycle_(cycle_time),
      limit_(settings.in_sync_limit),
      slowness_(std::max(1.0, static_cast<double>(cycle_time) / kUsualCycle)),
      host_(for_host(settings), cycle_time, set_value, least),
      forecast_(static_cast<double>(settings.max_valid_value)) {}

void Dcx::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  host_.start(base, first_reference_time, first_send_time);
  state_ = {};
  substitute_ = false;
  forecast_.start();
  forget();
  missing_since_.reset();
  integral_ = 0;
}

void Dcx::forget() {
  behind_.reset();
  known_since_.reset();
  near_since_.reset();
  closing_ = push_ = 0;
  met_ = apart_ = false;
}

/// The rate at which to come nearer, ppm: as fast as can still be braked, and the last bit in proportion to what is
/// left.
double Dcx::wanted_closing() const {
  const double approach = kApproach * slowness_, brake = kBrake / (slowness_ * slowness_);
  const double distance = std::abs(*behind_), last_bit = brake * approach * approach * 1e-6;
  const double speed =
      distance <= last_bit ? distance / approach * 1e6 : std::sqrt(2e6 * brake * (distance - last_bit / 2));
  return std::copysign(std::min(speed, kDcxFastestPpm), *behind_);
}

/// For the rate that it takes to come nearer.
void Dcx::steer(Nanoseconds passed) {
  const double per_ppm = substitute_ ? kPushPerPpm * kOfSubstitute : kPushPerPpm;
  const double push = std::clamp(per_ppm * (wanted_closing() - closing_), -kDcxMaxCorrection, kDcxMaxCorrection);
  const double most = kPushChange / (slowness_ * slowness_) * static_cast<double>(passed);
  push_ += std::clamp(push - push_, -most, most);
}

void Dcx::note_closing(double moved, Nanoseconds passed) {
  if (passed <= 0) return;
  const auto time = static_cast<double>(passed);
  const double ppm = moved / time * 1e6;
  if (std::abs(ppm) < kMostPpm) closing_ += (ppm - closing_) * time / (kRateFilter + time);
}

/// Who only comes by at the rate of his quartz has not met anybody; and who has left the limit is not back before it
/// has stayed there, or each reading at the limit would be a loss.
void Dcx::judge_external() {
  if (behind_) {
    const bool near = std::abs(*behind_) <= static_cast<double>(limit_);
    if (!near) near_since_.reset();
    if (near && !near_since_) near_since_ = seen_;
    const bool measured = seen_ - known_since_.value_or(seen_) > kMeasured;
    met_ = met_ || (near && measured && std::abs(closing_) < kTogetherPpm);
    apart_ = met_ && (!near || (apart_ && seen_ - *near_since_ <= kMeasured));
  }
  if (!known_since_) return;
  state_.external = !met_    ? SyncObstacle::kToExternalClock
                    : apart_ ? SyncObstacle::kExternalClock
                             : SyncObstacle::kNone;
}

/// Who leads now has its own rate, and what was pushed was another one's, unless the same one is back.
void Dcx::set_led_by_substitute(bool substitute) {
  if (!substitute && !substitute_) return;
  substitute_ = substitute;
  push_ = integral_ = 0;
}

std::optional<Nanoseconds> Dcx::reference_write(Nanoseconds send_time, Nanoseconds) {
  const auto forecast = forecast_.at(send_time, host_.state().drift_ppm);
  if (control_off_ || !behind_ || !forecast) return std::nullopt;
  return *forecast + std::llround(push_ + integral_);
}

DcmAction Dcx::observe(const DcmObservation& observation) {
  auto action = host_.observe(observation);
  if (observation.reference_time) {
    const auto& host = host_.state();
    const auto surprise = host.error - host.error_filtered;
    expected_lead_ = *observation.reference_time - observation.send_time - surprise;
    action.write_again =
        forecast_.take(observation, static_cast<double>(surprise), host.in_sync) == OutlierGate::Verdict::kOutlier;
  }
  take(observation);
  state_ = host_.state();
  state_.external_error = behind_ ? std::optional(std::llround(-*behind_)) : std::nullopt;
  const bool missing = missing_since_ && observation.send_time - *missing_since_ >= kPatience;
  if (missing) state_.error_code = kDcxErrorNoExternalClock;
  state_.in_sync = state_.in_sync && !missing;
  judge_external();
  return action;
}

bool Dcx::observe_second_write(const DcmObservation& observation) {
  if (!observation.reference_time) return false;
  const auto surprise = *observation.reference_time - observation.send_time - expected_lead_;
  return forecast_.take_again(observation, static_cast<double>(surprise));
}

void Dcx::take(const DcmObservation& observation) {
  if (!observation.external_difference) {
    if (observation.external_expected && !missing_since_) missing_since_ = observation.send_time;
    if (!observation.external_expected) missing_since_.reset();
    // One that is missed in a cycle or two has not gone away.
    if (!missing_since_ || observation.send_time - *missing_since_ >= kPatience) forget();
    behind_.reset();
    return;
  }
  missing_since_.reset();
  const auto behind = wrap_to_half(*observation.external_difference, cycle_);
  if (behind_) {
    const auto moved = wrap_to_half(std::llround(*behind_) - behind, cycle_);
    note_closing(static_cast<double>(moved), observation.send_time - seen_);
  }
  const auto passed = behind_ ? observation.send_time - seen_ : cycle_;
  behind_ = static_cast<double>(behind);
  seen_ = observation.send_time;
  if (!known_since_) known_since_ = seen_;
  steer(passed);
  // What is further away is a distance to go, and no rate to learn.
  if (std::abs(*behind_) > kNear) return;
  const double integral_time = kDcxIntegralTime * slowness_ * slowness_;
  integral_ =
      std::clamp(integral_ + static_cast<double>(cycle_) / integral_time * *behind_, -kDcxMaxIntegral, kDcxMaxIntegral);
}

}  // namespace syncline::dc
