// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "support/result.h"
#include "support/types.h"

namespace syncline {

class Bus;
struct InitCmd;
struct NetworkConfig;
struct SlaveConfig;
struct SlaveDcConfig;

/// Grid on which every slave's SYNC signals may start so that all of them fire together: the least
/// common multiple of the bus cycle and all SYNC cycles (and of the user's grid). The bus cycle where
/// that has no sensible size (more than a minute).
[[nodiscard]] Nanoseconds dc_start_grid(const NetworkConfig& config);

/// The init command writes the DC start time, which only the master knows.
[[nodiscard]] bool writes_dc_start_time(const InitCmd& command);

/// Start time of a slave's SYNC signals, system time, by its station address (EC-Master EC_T_DC_STARTTIME_CB_DESC). It
/// goes to the slave as it is, with the shift of the configuration only; nothing: the master calculates.
using DcStartTimeCallback = std::function<std::optional<Nanoseconds>(std::uint16_t station)>;

/// The init command writes a register of the cyclic unit, 0x0980 to 0x09A7.
[[nodiscard]] bool sets_sync_unit(const InitCmd& command);

/// What is known of how long it takes from writing the start time until the unit is active, when many slaves get the
/// commands of their lists side by side, one of each a step.
struct DcStartPace {
  std::size_t slaves = 1;        // side by side
  std::size_t steps_before = 0;  // commands of this slave's list in front of the start time
  std::size_t steps_until = 1;   // from the start time to the activation
  unsigned attempt = 0;          // that came too late before this one
};
/// Of a slave's list, in the order in which it is sent.
[[nodiscard]] DcStartPace dc_start_pace(std::span<const InitCmd* const> commands);
/// The time to allow for it. `elapsed`: since the list was begun; without a step in front of the start time the bytes
/// of all slaves are counted, a frame a cycle. Each attempt that came too late doubles it.
[[nodiscard]] Nanoseconds time_until_active(const DcStartPace& pace, Nanoseconds elapsed, Nanoseconds cycle);

/// Data of that command: the first SYNC0 of `slave`. `now`: system time of the reference clock; `base`: phase of
/// the SYNC grid; `until_active`: see time_until_active(). The shift is that of the slave's DC element, or the
/// command's own data.
[[nodiscard]] std::vector<std::uint8_t> dc_start_data(const NetworkConfig& config, const SlaveConfig& slave,
                                                      const InitCmd& command, Nanoseconds now, Nanoseconds base,
                                                      const DcStartTimeCallback& callback = {},
                                                      Nanoseconds until_active = 0);

/// What became of the SYNC signals of a slave.
struct DcStartReading {
  std::size_t slave = 0;
  std::optional<Error> error;       // its SYNC0 will not come
  std::optional<Nanoseconds> next;  // its next SYNC0, system time, as wide as its clock
};
/// Reads them back from slaves that were led to SAFEOP and answer: an error for each whose unit is not active or whose
/// SYNC0 will never come, because its start time has passed. Errors of the bus.
[[nodiscard]] Result<std::vector<DcStartReading>> read_dc_start(Bus& bus, const NetworkConfig& config,
                                                                std::span<const std::size_t> slaves);

/// How much later than in the grid that begins at `base` (shifted by the slave's own shift) its SYNC0 comes, within
/// half of its period either way. `now`: system time, to which a counter of 32 bits is completed.
[[nodiscard]] Nanoseconds sync0_off_grid(const NetworkConfig& config, const SlaveDcConfig& dc, Nanoseconds next,
                                         Nanoseconds base, Nanoseconds now);

/// The time in such data, extended to 64 bit where it is none.
[[nodiscard]] Nanoseconds written_start_time(std::span<const std::uint8_t> data, Nanoseconds now);

}  // namespace syncline
