// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/dcm_monitor.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

constexpr double kFilterTime = 20e6;  // ns
/// Drift that no controller is to balance: an ESC's loop reaches 763 ppm, and needs some of it itself.
constexpr double kMaxDriftPpm = 600;

}  // namespace

DcmMonitor::DcmMonitor(const DcmSettings& settings, Nanoseconds cycle_time, Nanoseconds set_value,
                       Nanoseconds least_set_value)
    : cycle_(cycle_time),
      valid_set_value_(set_value > 0 && set_value >= least_set_value && set_value < cycle_time),
      judge_(settings),
      bus_cycle_(cycle_time) {}

void DcmMonitor::start(Nanoseconds time) {
  judge_.start(time);
  drift_.start();
  bus_cycle_.start();
  error_ = 0;
  filtered_ = 0;
  running_away_ = false;
}

bool DcmMonitor::observe(const DcmObservation& observation, Nanoseconds error) {
  bus_cycle_.observe(observation.scheduled_time);
  if (!observation.reference_time) {
    judge_.observe_silence(observation.send_time);
    return false;
  }
  error_ = error;
  filtered_ += std::min(1.0, static_cast<double>(cycle_) / kFilterTime) * (static_cast<double>(error) - filtered_);
  judge_.observe(observation.send_time, static_cast<Nanoseconds>(std::llround(filtered_)));
  return drift_.observe(observation.send_time, *observation.reference_time);
}

std::uint32_t DcmMonitor::error_code() const {
  // A cause comes before its consequence.
  if (!valid_set_value_) return kDcmErrorInvalidSetValue;
  if (bus_cycle_.wrong()) return kDcmErrorBusCycleWrong;
  if (running_away_ || (drift_.valid() && std::abs(drift_.ppm()) > kMaxDriftPpm)) return kDcmErrorDriftTooHigh;
  if (judge_.was_in_sync() && !judge_.in_sync()) return kDcmErrorOutOfLimit;
  return 0;
}

void DcmMonitor::report(DcmState& state) const {
  state.error = error_;
  state.error_filtered = static_cast<Nanoseconds>(std::llround(filtered_));
  state.drift_ppm = drift_.ppm();
  state.in_sync = judge_.in_sync();
  state.in_sync_after = judge_.in_sync_after();
  state.error_code = error_code();
}

}  // namespace syncline::dc
