// SPDX-License-Identifier: Apache-2.0
#include "master/dc_start.h"

#include <algorithm>
#include <numeric>

#include "dc/plans.h"
#include "protocol/dc_registers.h"
#include "protocol/registers.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr Nanoseconds kLongestGrid = 60 * kSecond;
/// Start time, activation and their retries each take a cycle before the time must not have passed.
constexpr int kCyclesUntilActive = 6;

}  // namespace

Nanoseconds dc_start_grid(const NetworkConfig& config) {
  Nanoseconds grid = config.cycle_time();
  const auto include = [&](Nanoseconds cycle) {
    if (cycle > 0 && grid <= kLongestGrid) grid = std::lcm(grid, cycle);
  };
  include(config.dc.start_time_grid);
  for (const auto& slave : config.slaves) {
    if (!slave.dc) continue;
    include(slave.dc->cycle_time0);
    if (!AssignActivate{slave.dc->assign_activate}.sync1() || slave.dc->cycle_time0 <= 0) continue;
    // 0x09A4 is a delay after SYNC0; SYNC1 comes with every so many SYNC0 pulses.
    const auto every = slave.dc->cycle_time1 / slave.dc->cycle_time0 + 1;
    include(every * slave.dc->cycle_time0);
  }
  return grid <= kLongestGrid ? grid : config.cycle_time();
}

bool writes_dc_start_time(const InitCmd& command) {
  return command.ado == reg::kStartTimeCyclicOperation && command.length() >= 4 && !is_logical(command.command) &&
         writes(command.command);
}

std::vector<std::uint8_t> dc_start_data(const NetworkConfig& config, const SlaveConfig& slave,
                                        const InitCmd& command, Nanoseconds now, Nanoseconds base) {
  auto data = command.data;
  data.resize(command.length());
  dc::StartTimeInput input;
  input.now = now;
  input.safety = config.dc.start_time_safety + kCyclesUntilActive * config.cycle_time();
  input.grid = dc_start_grid(config);
  input.base = base;
  if (slave.dc) {
    input.shift = slave.dc->shift_time;
  } else {
    input.shift = static_cast<std::int32_t>(load_le<std::uint32_t>(data));
  }
  const auto start = static_cast<std::uint64_t>(dc::start_time(input));
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

}  // namespace syncline
