// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/master_shift.h"

#include <algorithm>
#include <cmath>

#include "dc/dcm/dcm_error.h"

namespace syncline::dc {
namespace {

struct Gains {
  double proportional, integral;  // of the error, per cycle
};
// Critically damped (integral = proportional^2 / 4); time constants of 20 and 200 cycles.
constexpr Gains kAcquire{0.1, 2.5e-3};
constexpr Gains kTrack{0.01, 2.5e-5};
constexpr double kMaxStep = 0.02;           // of the cycle
constexpr Nanoseconds kOutlier = 15'000;    // ns from the filtered error, after the first lock
constexpr int kOutliersAreTrue = 20;        // so many in a row are no outliers

}  // namespace

MasterShift::MasterShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value)
    : target_{0, set_value, cycle_time}, judge_(settings) {}

void MasterShift::start(Nanoseconds base, Nanoseconds, Nanoseconds first_send_time) {
  target_.base = base;
  judge_.start(first_send_time);
  drift_.start();
  state_ = {};
  filtered_ = integral_ = output_ = 0;
  outliers_ = 0;
}

bool MasterShift::is_outlier(Nanoseconds error) const {
  return judge_.was_in_sync() && std::abs(static_cast<double>(error) - filtered_) > kOutlier;
}

DcmAction MasterShift::observe(const DcmObservation& observation) {
  if (!observation.reference_time) return {static_cast<Nanoseconds>(std::llround(-integral_)), {}};  // coast
  const auto error = target_.error(observation);
  state_.error = error;
  (void)drift_.observe(observation.send_time, *observation.reference_time);

  outliers_ = is_outlier(error) ? outliers_ + 1 : 0;
  const bool gated = outliers_ > 0 && outliers_ < kOutliersAreTrue;
  if (!gated) {
    const auto& gains = judge_.was_in_sync() ? kTrack : kAcquire;
    filtered_ += 0.3 * (static_cast<double>(error) - filtered_);
    const auto cycle = static_cast<double>(target_.cycle);
    const double wanted = -(gains.proportional * static_cast<double>(error) + integral_);
    output_ = std::clamp(wanted, -kMaxStep * cycle, kMaxStep * cycle);
    // Anti-windup: what the clamp holds back must not pile up in the integral.
    if (output_ == wanted) integral_ += gains.integral * static_cast<double>(error);
    const double bound = 1.2 * kMaxDriftPpm * 1e-6 * cycle;
    integral_ = std::clamp(integral_, -bound, bound);
  } else {
    output_ = -integral_;
  }
  judge_.observe(observation.send_time, error);
  update_state();
  return {static_cast<Nanoseconds>(std::llround(output_)), {}};
}

void MasterShift::update_state() {
  state_.error_filtered = static_cast<Nanoseconds>(std::llround(filtered_));
  state_.drift_ppm = drift_.ppm();
  state_.adjust = static_cast<Nanoseconds>(std::llround(output_));
  state_.in_sync = judge_.in_sync();
  state_.in_sync_after = judge_.in_sync_after();
  state_.error_code = dcm_error_code(drift_, judge_);
}

}  // namespace syncline::dc
