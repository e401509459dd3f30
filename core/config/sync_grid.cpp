// SPDX-License-Identifier: Apache-2.0
#include "config/sync_grid.h"

#include <numeric>

#include "config/network_config.h"
#include "protocol/assign_activate.h"

namespace syncline {
namespace {

constexpr Nanoseconds kLongestGrid = 60 * kSecond;

}  // namespace

std::optional<Nanoseconds> sync_grid(const NetworkConfig& config) {
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
  return grid <= kLongestGrid ? std::optional(grid) : std::nullopt;
}

}  // namespace syncline
