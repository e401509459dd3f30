// SPDX-License-Identifier: Apache-2.0
#include "trace/sync0_slaves.h"

#include "config/command_data.h"
#include "config/frame_time.h"
#include "config/network_config.h"
#include "config/sync_grid.h"
#include "protocol/assign_activate.h"

namespace syncline {
namespace {

Sync0Slave sync0_slave(const NetworkConfig& config, std::size_t position, bool whole_grid) {
  const auto& from = config.slaves[position];
  const auto cycle = config.cycle_time();
  if (!from.dc || !AssignActivate{from.dc->assign_activate}.sync0() || cycle <= 0) return {};
  if (outputs_task(config, position) != 0U) return {};  // a sample does not say with which cycles a slower task went
  const auto wire = outputs_wire_time(config, position);
  const auto period = from.dc->cycle_time0 > 0 ? from.dc->cycle_time0 : cycle;
  if (wire <= 0 || (!whole_grid && cycle % period != 0)) return {};
  return {period, from.dc->shift_time, wire, period % cycle == 0 ? static_cast<int>(period / cycle) : 0};
}

}  // namespace

std::vector<Sync0Slave> sync0_slaves(const NetworkConfig& config) {
  std::vector<Sync0Slave> slaves;
  const bool whole_grid = sync_grid(config).has_value();
  for (std::size_t i = 0; i < config.slaves.size(); ++i) slaves.push_back(sync0_slave(config, i, whole_grid));
  return slaves;
}

}  // namespace syncline
