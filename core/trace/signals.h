// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "channels/cycle_sample.h"

namespace syncline {

/// A figure that every cycle has, under the name by which others know it.
struct Signal {
  std::string_view name, unit;
  std::optional<double> (*value)(const CycleSample&);
};

/// The two clock differences of MathWorks' EtherCAT Init block, ns:
/// - NetworkToSubDeviceClkDiff: slaves against the reference clock, the wire-ored 0x092C;
/// - MdeviceToNetworkClkDiff: the master's schedule in the SYNC grid of the reference clock.
/// Without distributed clocks both are zero, as there.
[[nodiscard]] std::span<const Signal> clock_difference_signals();

}  // namespace syncline
