// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_timeline.h"

#include <algorithm>

#include "config/frame_time.h"
#include "config/network_config.h"
#include "protocol/assign_activate.h"
#include "protocol/command.h"
#include "protocol/registers.h"

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

/// Status and times of both latches.
bool is_latched(unsigned address) { return address >= reg::kLatch0Status && address < reg::kLatch1NegativeEdge + 8U; }

bool frames_read_latches(const NetworkConfig& config, const SlaveConfig& slave) {
  const auto mapped = [](const ConfiguredSyncManager& manager) {
    return !manager.pdos.empty() && is_latched(manager.description.start_address);
  };
  if (std::ranges::any_of(slave.sync_managers, mapped)) return true;
  for (const auto& task : config.cyclic) {
    for (const auto& frame : task.frames) {
      for (const auto& cmd : frame.commands) {
        if (cmd.command == Command::kFprd && cmd.adp == slave.station_address && is_latched(cmd.ado)) return true;
      }
    }
  }
  return false;
}

std::optional<SlaveTiming::Latch> latch_of(const NetworkConfig& config, const SlaveConfig& slave,
                                           AssignActivate activate) {
  SlaveTiming::Latch latch;
  latch.by_device = activate.latch_to_pdi();
  for (const InitCmd& cmd : slave.init_cmds) {
    const bool control = cmd.ado == reg::kLatch0Control || cmd.ado == reg::kLatch1Control;
    if (control && writes(cmd.command))
      latch.single = std::ranges::any_of(cmd.data, [](auto byte) { return byte != 0; });
  }
  latch.in_frames = frames_read_latches(config, slave);
  return latch == SlaveTiming::Latch{} ? std::nullopt : std::optional(latch);
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
  timing.latch = latch_of(config, config.slaves[slave], activate);
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
  if (timing.latch && timing.latch->in_frames) line.latch_reads = edges(timing.delay, timing.bus_cycle, line.length);
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
