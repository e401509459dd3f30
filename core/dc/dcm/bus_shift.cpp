// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_shift.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "dc/dcm/dcm_error.h"

namespace syncline::dc {
namespace {

constexpr double kFilterTime = 20e6;       // ns; well below the ESC loop's 84 ms
constexpr double kIntegralTime = 500e6;    // ns; well above it, so that the two loops do not fight
constexpr double kMaxCorrection = 20'000;  // ns; an ESC at its slew limit is not helped by more

}  // namespace

BusShift::BusShift(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value)
    : target_{0, set_value, cycle_time}, judge_(settings) {}

void BusShift::start(Nanoseconds base, Nanoseconds first_reference_time, Nanoseconds first_send_time) {
  target_.base = base;
  judge_.start(first_send_time);
  drift_.start();
  state_ = {};
  filtered_ = integral_ = 0;
  anchor_host_ = first_send_time;
  // Nearest place in the grid: the clock is never asked to jump.
  anchor_reference_ = first_reference_time -
                      wrap_to_half(first_reference_time - (target_.base - target_.set_value), target_.cycle);
}

std::optional<Nanoseconds> BusShift::reference_write(Nanoseconds send_time, Nanoseconds) {
  // Counted from the real send time: a frame that leaves late carries a later time.
  return anchor_reference_ + (send_time - anchor_host_) - static_cast<Nanoseconds>(std::llround(integral_));
}

DcmAction BusShift::observe(const DcmObservation& observation) {
  if (!observation.reference_time) return {};
  const auto error = target_.error(observation);
  (void)drift_.observe(observation.send_time, *observation.reference_time);
  const auto cycle = static_cast<double>(target_.cycle);
  filtered_ += std::min(1.0, cycle / kFilterTime) * (static_cast<double>(error) - filtered_);
  integral_ = std::clamp(integral_ + cycle / kIntegralTime * filtered_, -kMaxCorrection, kMaxCorrection);
  state_.error = error;
  judge_.observe(observation.send_time, error);
  update_state();
  return {};
}

void BusShift::update_state() {
  state_.error_filtered = static_cast<Nanoseconds>(std::llround(filtered_));
  state_.drift_ppm = drift_.ppm();
  state_.adjust = static_cast<Nanoseconds>(std::llround(-integral_));
  state_.in_sync = judge_.in_sync();
  state_.in_sync_after = judge_.in_sync_after();
  state_.error_code = dcm_error_code(drift_, judge_);
}

}  // namespace syncline::dc
