// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline {

enum class Signal : std::uint8_t;
struct DcMasterSettings;
struct NetworkConfig;

/// What the run is held against, out of the configuration that runs.
struct RunLimits {
  Nanoseconds cycle_time = kMillisecond;
  std::uint32_t deviation_ns = 0;  // of the slaves: 2^n - 1; 0: not monitored
  Nanoseconds dcm_error_ns = 0;    // of the master; 0: no master synchronisation
  bool operator==(const RunLimits&) const = default;
};
[[nodiscard]] RunLimits limits_of(const NetworkConfig& config);
[[nodiscard]] RunLimits limits_of(Nanoseconds cycle_time, const DcMasterSettings& dc);
/// The magnitude that a signal is held against, in its unit; 0: none.
[[nodiscard]] double limit_of(const RunLimits& limits, Signal signal);
/// Register 0x0930 as the configuration sets it.
[[nodiscard]] std::uint16_t speed_counter_start_of(const NetworkConfig& config);

/// What of a run may change while it goes on; who records it tells what is now.
struct RunStanding {
  RunLimits limits;
  std::optional<Nanoseconds> armed;  // host clock, see SyncOverview
  bool operator==(const RunStanding&) const = default;
};

}  // namespace syncline
