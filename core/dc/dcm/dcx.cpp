// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcx.h"

#include <algorithm>
#include <cmath>

#include "dc/plans.h"

namespace syncline::dc {
namespace {

constexpr double kShare = 0.2;
constexpr double kIntegralTime = 2.5e9;    // ns
constexpr double kMaxCorrection = 5'000;   // ns: moves an ESC by some 60 ppm, which the host can follow
constexpr std::uint32_t kLeastGain = 20;   // ppt: the clock that the host follows is being moved
constexpr Nanoseconds kPatience = kSecond;

DcmSettings for_host(DcmSettings settings) {
  settings.mode = DcmMode::kMasterShift;
  settings.gain_ppt = std::max(settings.gain_ppt, kLeastGain);
  return settings;
}

}  // namespace

Dcx::Dcx(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least)
    : control_off_(settings.control_off),
      cycle_(cycle_time),
      limit_(settings.in_sync_limit),
      host_(for_host(settings), cycle_time, set_value, least) {}

void Dcx::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  host_.start(base, first_reference_time, first_send_time);
  state_ = {};
  last_.reset();
  behind_.reset();
  missing_since_.reset();
  integral_ = 0;
}

std::optional<Nanoseconds> Dcx::reference_write(Nanoseconds send_time, Nanoseconds) {
  if (control_off_ || !behind_ || !last_) return std::nullopt;
  const auto passed = static_cast<double>(send_time - last_->host_time) * (1 + host_.state().drift_ppm * 1e-6);
  const double push = std::clamp(kShare * *behind_, -kMaxCorrection, kMaxCorrection) + integral_;
  return last_->reference_time + std::llround(passed + push);
}

DcmAction Dcx::observe(const DcmObservation& observation) {
  const auto action = host_.observe(observation);
  if (observation.reference_time) last_ = Reading{observation.send_time, *observation.reference_time};
  take(observation);
  state_ = host_.state();
  state_.external_error = behind_ ? std::optional(std::llround(-*behind_)) : std::nullopt;
  const bool missing = missing_since_ && observation.send_time - *missing_since_ >= kPatience;
  if (missing) state_.error_code = kDcxErrorNoExternalClock;
  if (missing || (behind_ && std::abs(*behind_) > static_cast<double>(limit_))) state_.in_sync = false;
  return action;
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
  const double seen = std::clamp(*behind_, -kMaxCorrection, kMaxCorrection);
  integral_ = std::clamp(integral_ + static_cast<double>(cycle_) / kIntegralTime * seen, -kMaxCorrection, kMaxCorrection);
}

}  // namespace syncline::dc
