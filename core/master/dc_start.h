// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "config/network_config.h"
#include "master/bus.h"

namespace syncline {

/// Grid on which every slave's SYNC signals may start so that all of them fire together: the least
/// common multiple of the bus cycle and all SYNC cycles (and of the user's grid). The bus cycle where
/// that has no sensible size (more than a minute).
[[nodiscard]] Nanoseconds dc_start_grid(const NetworkConfig& config);

/// The init command writes the DC start time, which only the master knows.
[[nodiscard]] bool writes_dc_start_time(const InitCmd& command);

/// Start time of a slave's SYNC signals, system time, by its station address (EC-Master EC_T_DC_STARTTIME_CB_DESC). It
/// goes to the slave as it is, with the shift of the configuration only; nothing: the master calculates.
using DcStartTimeCallback = std::function<std::optional<Nanoseconds>(std::uint16_t station)>;

/// Data of that command: the first SYNC0 of `slave`. `now`: system time of the reference clock; `base`: phase of
/// the SYNC grid. The shift is that of the slave's DC element, or the command's own data.
[[nodiscard]] std::vector<std::uint8_t> dc_start_data(const NetworkConfig& config, const SlaveConfig& slave,
                                                      const InitCmd& command, Nanoseconds now, Nanoseconds base,
                                                      const DcStartTimeCallback& callback = {});

/// Reads back what became of the SYNC signals of slaves that were led to SAFEOP: an error for each whose unit is not
/// active or whose SYNC0 will never come, because its start time has passed. Errors of the bus.
[[nodiscard]] Result<std::vector<Error>> check_dc_start(Bus& bus, const NetworkConfig& config,
                                                        std::span<const std::size_t> slaves);

/// The time in such data, extended to 64 bit where it is none.
[[nodiscard]] Nanoseconds written_start_time(std::span<const std::uint8_t> data, Nanoseconds now);

}  // namespace syncline
