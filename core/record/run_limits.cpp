// SPDX-License-Identifier: Apache-2.0
#include "record/run_limits.h"

#include <algorithm>

#include "config/network_config.h"
#include "dc/clock_registers.h"
#include "protocol/system_time_difference.h"
#include "trace/signals.h"

namespace syncline {

RunLimits limits_of(const NetworkConfig& config) { return limits_of(config.cycle_time(), config.dc); }

RunLimits limits_of(Nanoseconds cycle_time, const DcMasterSettings& dc) {
  RunLimits limits;
  limits.cycle_time = cycle_time;
  if (!dc.enabled) return limits;
  if (dc.sync_window.enabled) limits.deviation_ns = sync_window_limit_ns(dc.sync_window.exponent);
  if (dc.dcm.mode != DcmMode::kOff) limits.dcm_error_ns = effective_dcm_settings(dc.dcm).in_sync_limit;
  return limits;
}

double limit_of(const RunLimits& limits, Signal signal) {
  switch (signal) {
    case Signal::kDeviation:
    case Signal::kDeviationOred:
    case Signal::kNetworkToSlave:
    case Signal::kSlaveDeviation:
      return limits.deviation_ns;
    case Signal::kDcmError:
    case Signal::kDcmErrorFiltered:
    case Signal::kMasterToNetwork:
      return static_cast<double>(limits.dcm_error_ns);
    default:
      return 0;
  }
}

std::uint16_t speed_counter_start_of(const NetworkConfig& config) {
  const auto cycle_time = std::max<Nanoseconds>(config.cycle_time(), 1);
  return config.dc.loop.speed_counter_start.value_or(dc::speed_counter_start(cycle_time));
}

}  // namespace syncline
