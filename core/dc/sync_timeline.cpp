// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_timeline.h"

#include <algorithm>

#include "config/frame_time.h"
#include "config/network_config.h"
#include "protocol/dc_registers.h"

namespace syncline::dc {
namespace {

/// The first of a series that is not before 0.
Nanoseconds first_edge(Nanoseconds any, Nanoseconds period) {
  const auto rest = any % period;
  return rest < 0 ? rest + period : rest;
}

std::vector<Nanoseconds> edges(Nanoseconds any, Nanoseconds period, Nanoseconds length) {
  std::vector<Nanoseconds> result;
  for (auto edge = first_edge(any, period); edge < length && result.size() < kMostEdges; edge += period) {
    result.push_back(edge);
  }
  return result;
}

}  // namespace

std::optional<SlaveTiming> slave_timing(const NetworkConfig& config, std::size_t slave) {
  if (slave >= config.slaves.size()) return std::nullopt;
  const auto& dc = config.slaves[slave].dc;
  const AssignActivate activate{dc ? dc->assign_activate : std::uint16_t{0}};
  if (!activate.unit_on() || !activate.sync0() || dc->cycle_time0 <= 0 || config.cycle_time() <= 0) return std::nullopt;
  SlaveTiming timing;
  timing.bus_cycle = config.cycle_time();
  timing.set_value = effective_set_value(config.dc.dcm, timing.bus_cycle);
  timing.wire = outputs_wire_time(config, slave);
  timing.sync0 = {dc->shift_time, dc->cycle_time0};
  if (activate.sync1() && dc->cycle_time1 >= 0) timing.sync1 = dc->cycle_time1;
  return timing;
}

SyncTimeline sync_timeline(const SlaveTiming& timing) {
  SyncTimeline line;
  const auto period0 = timing.sync0.period;
  const auto period1 = timing.sync1 ? sync1_period(period0, *timing.sync1) : 0;
  line.length = std::max({timing.bus_cycle, period0, period1});
  const auto grid = timing.set_value + timing.sync0.first;
  line.sync0 = edges(grid, period0, line.length);
  if (timing.sync1) line.sync1 = edges(grid + *timing.sync1, period1, line.length);
  if (timing.wire <= 0) return line;
  const Sync0Grid from_frame{grid, period0};
  for (Nanoseconds passed = 0; passed < line.length && line.outputs.size() < kMostEdges; passed += timing.bus_cycle) {
    const auto arrived = outputs_arrival(passed, timing.delay, timing.wire);
    line.outputs.push_back({passed + timing.delay, arrived});
    if (timing.compute) line.compute.push_back({arrived, arrived + *timing.compute});
    const auto margin = sync0_arrival(from_frame, arrived).margin;
    line.margin = std::min(line.margin.value_or(margin), margin);
  }
  return line;
}

}  // namespace syncline::dc
