// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/network_config.h"

namespace syncline {

/// Grid on which every slave's SYNC signals may start so that all of them fire together: the least
/// common multiple of the bus cycle and all SYNC cycles (and of the user's grid). The bus cycle where
/// that has no sensible size (more than a minute).
[[nodiscard]] Nanoseconds dc_start_grid(const NetworkConfig& config);

/// The init command writes the DC start time, which only the master knows.
[[nodiscard]] bool writes_dc_start_time(const InitCmd& command);

/// Data of that command: the first SYNC0 of `slave`. `now`: system time of the reference clock; `base`: phase of
/// the SYNC grid. The shift is that of the slave's DC element, or the command's own data.
[[nodiscard]] std::vector<std::uint8_t> dc_start_data(const NetworkConfig& config, const SlaveConfig& slave,
                                                      const InitCmd& command, Nanoseconds now, Nanoseconds base);

/// The time in such data, extended to 64 bit where it is none.
[[nodiscard]] Nanoseconds written_start_time(std::span<const std::uint8_t> data, Nanoseconds now);

}  // namespace syncline
