// SPDX-License-Identifier: Apache-2.0
#include "master/clocks/dc_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/init_cmd.h"
#include "config/network_config.h"
#include "config/sync_grid.h"
#include "dc/clock_registers.h"
#include "dc/start_time.h"
#include "dc/sync0_arrival.h"
#include "master/exchange/bus.h"
#include "protocol/assign_activate.h"
#include "protocol/datagram.h"
#include "protocol/registers.h"
#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

/// Start time, activation and their retries each take a cycle before the time must not have passed.
constexpr int kCyclesUntilActive = 6;
/// A step that has to be repeated, because a frame got lost.
constexpr std::size_t kSpareSteps = 1;
constexpr std::size_t kBytesPerFrame = 1400, kBytesPerStep = 24;  // a datagram of 8 bytes and its header
constexpr unsigned kMostDoublings = 6;

}  // namespace

Nanoseconds dc_start_grid(const NetworkConfig& config) { return sync_grid(config).value_or(config.cycle_time()); }

bool writes_dc_start_time(const InitCmd& command) {
  return command.ado == reg::kStartTimeCyclicOperation && command.length() >= 4 && !is_logical(command.command) &&
         writes(command.command);
}

bool sets_sync_unit(const InitCmd& command) {
  constexpr std::uint16_t kEnd = reg::kSync0CycleTime + 8;
  return writes(command.command) && !is_logical(command.command) && command.ado >= reg::kCyclicUnitControl &&
         command.ado < kEnd;
}

DcStartPace dc_start_pace(std::span<const InitCmd* const> commands) {
  const auto start =
      std::ranges::find_if(commands, [](const InitCmd* command) { return writes_dc_start_time(*command); });
  const auto activation = std::find_if(start, commands.end(), [](const InitCmd* command) {
    return sets_sync_unit(*command) && command->ado <= reg::kActivation;
  });
  DcStartPace pace;
  pace.steps_before = static_cast<std::size_t>(start - commands.begin());
  if (activation != commands.end()) pace.steps_until = static_cast<std::size_t>(activation - start);
  return pace;
}

Nanoseconds time_until_active(const DcStartPace& pace, Nanoseconds elapsed, Nanoseconds cycle) {
  const auto frames = static_cast<Nanoseconds>(pace.slaves * kBytesPerStep / kBytesPerFrame + 1);
  const auto step = pace.steps_before > 0 ? elapsed / static_cast<Nanoseconds>(pace.steps_before) : frames * cycle;
  // The step that writes the start time itself, and those until the activation has come to the last slave.
  const auto steps = static_cast<Nanoseconds>(pace.steps_until + 1 + kSpareSteps);
  return steps * step * (Nanoseconds{1} << std::min(pace.attempt, kMostDoublings));
}

std::vector<std::uint8_t> dc_start_data(const NetworkConfig& config, const SlaveConfig& slave, const InitCmd& command,
                                        Nanoseconds now, Nanoseconds base, const DcStartTimeCallback& callback,
                                        Nanoseconds until_active) {
  auto data = command.data;
  data.resize(command.length());
  dc::StartTimeInput input;
  input.now = now;
  input.safety = config.dc.start_time_safety + kCyclesUntilActive * config.cycle_time() + until_active;
  input.grid = dc_start_grid(config);
  input.base = base;
  if (slave.dc) {
    input.shift = slave.dc->shift_time;
  } else {
    input.shift = static_cast<std::int32_t>(load_le<std::uint32_t>(data));
  }
  const auto own = callback ? callback(slave.station_address) : std::nullopt;
  const auto start = static_cast<std::uint64_t>(own ? *own + input.shift : dc::start_time(input));
  if (data.size() >= 8) {
    store_le(data, start);
  } else {
    store_le(data, static_cast<std::uint32_t>(start));
  }
  return data;
}

Nanoseconds written_start_time(std::span<const std::uint8_t> data, Nanoseconds now) {
  if (data.size() >= 8) return static_cast<Nanoseconds>(load_le<std::uint64_t>(data));
  return data.size() >= 4 ? dc::extend_32bit(load_le<std::uint32_t>(data), now) : 0;
}

namespace {

/// 0x0980..0x0997: activation, its status and the next SYNC0, and the time of reading them.
struct SyncReading {
  std::array<std::uint8_t, 24> unit{};
  std::array<std::uint8_t, 8> time{};
  Datagram read_unit, read_time;
};

/// How far ahead `next` lies, on a counter as wide as the slave's.
std::int64_t ahead_of(std::uint64_t next, std::uint64_t now, bool wide) {
  return wide ? static_cast<std::int64_t>(next - now) : static_cast<std::int32_t>(next - now);
}

DcStartReading judge(const SyncReading& reading, const SlaveConfig& slave, std::size_t position) {
  constexpr std::size_t kActivationAt = 1, kStatusAt = 4, kNextAt = 0x10;
  const std::span<const std::uint8_t> unit(reading.unit);
  const auto name = fmt::format("slave {} ({})", position, slave.name);
  DcStartReading result{position, {}, {}};
  if ((unit[kActivationAt] & 0x01) == 0) {
    result.error = Error{ErrorCode::kDcSetup, name, because("its SYNC unit is not active (0x0981)")};
    return result;
  }
  if (!reading.read_time.done()) return result;
  const auto next = load_le<std::uint64_t>(unit.subspan(kNextAt));
  const auto now = load_le<std::uint64_t>(reading.time);
  // A clock of 32 bits leaves the upper word of both at zero.
  const bool wide = (next >> 32) != 0 && (now >> 32) != 0;
  const auto ahead = ahead_of(next, now, wide);
  // Between the two readings of a frame a pulse may come.
  if ((unit[kStatusAt] & 0x01) == 0 || ahead > 0) {
    result.next = static_cast<Nanoseconds>(next);
  } else {
    result.error =
        Error{ErrorCode::kDcSetup, name,
              because("its SYNC0 will never come: the start time {start} (0x0990) had passed by {late} ns at {time}",
                      next, -ahead, now)};
  }
  return result;
}

}  // namespace

Nanoseconds sync0_off_grid(const NetworkConfig& config, const SlaveDcConfig& dc, Nanoseconds next, Nanoseconds base,
                           Nanoseconds now) {
  const auto period = dc.cycle_time0 > 0 ? dc.cycle_time0 : config.cycle_time();
  constexpr Nanoseconds kLowWord = 0xFFFFFFFF;
  if (next <= kLowWord) next = dc::extend_32bit(static_cast<std::uint32_t>(next), now);
  const dc::Sync0Grid grid{base + dc.shift_time, period};
  return dc::wrap_to_half(dc::sync0_arrival(grid, next).phase, period);
}

Result<std::vector<DcStartReading>> read_dc_start(Bus& bus, const NetworkConfig& config,
                                                  std::span<const std::size_t> slaves) {
  std::vector<std::size_t> asked;
  for (const auto slave : slaves) {
    const auto& dc = config.slaves[slave].dc;
    const bool sync0 =
        dc && AssignActivate{dc->assign_activate}.unit_on() && AssignActivate{dc->assign_activate}.sync0();
    const auto& commands = config.slaves[slave].init_cmds;
    if (sync0 && std::ranges::any_of(commands, writes_dc_start_time)) asked.push_back(slave);
  }
  std::vector<SyncReading> readings(asked.size());
  std::vector<Datagram> reads;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto station = config.slaves[asked[i]].station_address;
    reads.push_back({Command::kFprd, device_address(station, reg::kCyclicUnitControl), readings[i].unit});
    reads.push_back({Command::kFprd, device_address(station, reg::kSystemTime), readings[i].time});
  }
  if (reads.empty()) return std::vector<DcStartReading>{};
  if (auto status = bus.transact(reads); !status) return tl::unexpected(status.error());
  std::vector<DcStartReading> result;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    readings[i].read_unit = reads[2 * i];
    readings[i].read_time = reads[2 * i + 1];
    if (!readings[i].read_unit.done()) continue;  // gone: the next sweep tells
    result.push_back(judge(readings[i], config.slaves[asked[i]], asked[i]));
  }
  return result;
}

}  // namespace syncline
