// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/rate_changes.h"

#include <cmath>

#include "config/sim_config.h"

namespace syncline::sim {

std::vector<RateChange> rate_changes(const SimConfig& config, std::size_t slave, Nanoseconds start) {
  std::vector<RateChange> changes;
  for (const auto& fault : config.faults) {
    const auto begin = start + fault.at;
    if (fault.kind == FaultKind::kTemperatureRamp &&
        (fault.slave < 0 || static_cast<std::size_t>(fault.slave) == slave)) {
      changes.push_back({begin, start + fault.until, fault.slave < 0 ? -fault.ppm : fault.ppm});
    }
    if (fault.kind == FaultKind::kClockSlew && fault.ppm > 0) {
      const double ppm = fault.value_ns > 0 ? -fault.ppm : fault.ppm;
      const auto end = begin + std::llround(std::abs(static_cast<double>(fault.value_ns)) / (fault.ppm * 1e-6));
      changes.push_back({begin, begin, ppm});
      changes.push_back({end, end, -ppm});
    }
  }
  return changes;
}

}  // namespace syncline::sim
