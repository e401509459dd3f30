// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/master_shift.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

struct Gains {
  double proportional, integral;  // of the error, per cycle
};
// Critically damped (integral = proportional^2 / 4); time constants of 20 and 200 cycles.
constexpr Gains kAcquire{0.1, 2.5e-3};
constexpr Gains kTrack{0.01, 2.5e-5};
constexpr double kMaxDrift = 1000e-6;        // of the cycle; what is reported as too high is still balanced
constexpr double kMaxStep = 0.02;            // of the cycle
constexpr double kOutlier = 15'000;          // ns from the smoothed error, while in sync
constexpr int kOutliersAreTrue = 20;         // so many in a row are no outliers
constexpr double kSmoothing = 0.3;

}  // namespace

MasterShift::MasterShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value, Nanoseconds least)
    : target_{0, set_value, cycle_time}, monitor_(settings, cycle_time, set_value, least) {}

void MasterShift::start(Nanoseconds base, Nanoseconds, Nanoseconds first_send_time) {
  target_.base = base;
  monitor_.start(first_send_time);
  state_ = {};
  smoothed_ = integral_ = output_ = 0;
  outliers_ = 0;
}

DcmAction MasterShift::observe(const DcmObservation& observation) {
  const auto error = observation.reference_time ? target_.error(observation) : 0;
  monitor_.observe(observation, error);
  if (observation.reference_time && !is_gated(static_cast<double>(error))) {
    control(static_cast<double>(error));
  } else {
    output_ = -integral_;  // coast: the drift is known, the phase is not
  }
  monitor_.report(state_);
  state_.adjust = static_cast<Nanoseconds>(std::llround(output_));
  return {state_.adjust, {}};
}

bool MasterShift::is_gated(double error) {
  const bool outlier = monitor_.in_sync() && std::abs(error - smoothed_) > kOutlier;
  outliers_ = outlier ? outliers_ + 1 : 0;
  return outlier && outliers_ < kOutliersAreTrue;
}

void MasterShift::control(double error) {
  smoothed_ += kSmoothing * (error - smoothed_);
  const auto& gains = monitor_.in_sync() ? kTrack : kAcquire;
  const auto cycle = static_cast<double>(target_.cycle);
  output_ = std::clamp(-(gains.proportional * error + integral_), -kMaxStep * cycle, kMaxStep * cycle);
  // No more than a drift can be: what a large error piled up would have to be worked off beyond the grid.
  integral_ = std::clamp(integral_ + gains.integral * error, -kMaxDrift * cycle, kMaxDrift * cycle);
}

}  // namespace syncline::dc
