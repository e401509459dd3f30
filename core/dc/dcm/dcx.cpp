// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcx.h"

#include <algorithm>
#include <cmath>

#include "config/dcm_settings.h"
#include "dc/clock_registers.h"
#include "protocol/dcm_error.h"

namespace syncline::dc {
namespace {

constexpr double kShare = 0.2;
constexpr double kDcxIntegralTime = 2.5e9;  // ns
constexpr double kDcxMaxIntegral = 5'000;   // ns
/// ns: moves an ESC by some 10 ppm. Slaves follow one that moves about 8 ms behind, so that they stay within a window
/// of 127 ns; who is half a millisecond away needs a minute.
constexpr double kDcxMaxCorrection = 600;
constexpr std::uint32_t kLeastGain = 20;  // ppt: the clock that the host follows is being moved
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
      host_(for_host(settings), cycle_time, set_value, least),
      forecast_(static_cast<double>(settings.max_valid_value)) {}

void Dcx::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  host_.start(base, first_reference_time, first_send_time);
  state_ = {};
  forecast_.start();
  behind_.reset();
  missing_since_.reset();
  integral_ = 0;
}

std::optional<Nanoseconds> Dcx::reference_write(Nanoseconds send_time, Nanoseconds) {
  const auto forecast = forecast_.at(send_time, host_.state().drift_ppm);
  if (control_off_ || !behind_ || !forecast) return std::nullopt;
  const double push = std::clamp(kShare * *behind_, -kDcxMaxCorrection, kDcxMaxCorrection) + integral_;
  return *forecast + std::llround(push);
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
  if (missing || (behind_ && std::abs(*behind_) > static_cast<double>(limit_))) state_.in_sync = false;
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
    behind_.reset();
    return;
  }
  missing_since_.reset();
  behind_ = static_cast<double>(wrap_to_half(*observation.external_difference, cycle_));
  // What is further away is a distance to go, and no rate to learn.
  if (kShare * std::abs(*behind_) > kDcxMaxCorrection) return;
  integral_ = std::clamp(integral_ + static_cast<double>(cycle_) / kDcxIntegralTime * *behind_, -kDcxMaxIntegral,
                         kDcxMaxIntegral);
}

}  // namespace syncline::dc
