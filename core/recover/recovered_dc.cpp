// SPDX-License-Identifier: Apache-2.0
#include "recover/recovered_dc.h"

#include <span>

#include "config/dc_description.h"
#include "config/device_description.h"
#include "config/init_cmd.h"
#include "config/slave_config.h"
#include "config/sync0_cycle.h"
#include "protocol/registers.h"
#include "recover/recovered_device.h"
#include "support/byte_order.h"

namespace syncline::recover {
namespace {

constexpr std::uint16_t kSync1 = 0x0400;

DcTime cycle_of(Nanoseconds cycle, Nanoseconds bus_cycle) {
  DcTime time;
  if (cycle != 0 && cycle == bus_cycle) {
    time.factor = 1;
  } else {
    time.value_ns = cycle;
  }
  return time;
}

bool sets(const compiler::DcTimes& times, const SlaveDcConfig& wanted) {
  return times.cycle_time0 == wanted.cycle_time0 && times.cycle_time1 == wanted.cycle_time1 &&
         times.shift_time == wanted.shift_time;
}

/// The user's values where those of the mode give something else.
void set_times(DcSlaveSettings& settings, const DcOpMode& mode, const SlaveDcConfig& wanted, Nanoseconds bus_cycle) {
  if (compiler::dc_times(mode, settings, bus_cycle).cycle_time0 != wanted.cycle_time0) {
    settings.sync0.user_cycle = wanted.cycle_time0;
  }
  if (compiler::dc_times(mode, settings, bus_cycle).shift_time != wanted.shift_time) {
    settings.sync0.shift = wanted.shift_time;
  }
  // From SYNC0 to SYNC1 is what counts; that it comes from a shift is one of the ways to say so.
  if (compiler::dc_times(mode, settings, bus_cycle).cycle_time1 != wanted.cycle_time1) {
    settings.sync1.user_cycle = wanted.cycle_time0;
    settings.sync1.shift = wanted.cycle_time1;
  }
}

}  // namespace

std::optional<SlaveDcConfig> dc_of(const SlaveConfig& slave) {
  SlaveDcConfig dc = slave.dc.value_or(SlaveDcConfig{});
  bool found = slave.dc.has_value();
  for (const InitCmd& cmd : slave.init_cmds) {
    if (cmd.transitions != std::vector{Transition::kPS}) continue;
    const std::span<const std::uint8_t> data(cmd.data);
    if (cmd.ado == reg::kCyclicUnitControl && data.size() >= 2 && load_le<std::uint16_t>(data) != 0) {
      dc.assign_activate = load_le<std::uint16_t>(data);
      found = true;
    } else if (cmd.ado == reg::kSync0CycleTime && data.size() >= 4) {
      dc.cycle_time0 = load_le<std::uint32_t>(data);
      if (data.size() >= 8) dc.cycle_time1 = load_le<std::uint32_t>(data.subspan(4));
    } else if (cmd.ado == reg::kSync1CycleTime && data.size() >= 4) {
      dc.cycle_time1 = load_le<std::uint32_t>(data);
    }
  }
  return found ? std::optional(dc) : std::nullopt;
}

std::optional<DcDescription> recovered_dc(const SlaveConfig& slave, Nanoseconds bus_cycle) {
  const auto dc = dc_of(slave);
  if (!dc) return std::nullopt;
  DcDescription description;
  description.potential_reference_clock = dc->potential_reference_clock;
  if (dc->assign_activate == 0) {
    description.time_loop_control_only = true;
    return description;
  }
  DcOpMode mode;
  mode.name = kOpMode;
  mode.description = (dc->assign_activate & kSync1) != 0 ? "SYNC0 and SYNC1" : "SYNC0";
  mode.assign_activate = dc->assign_activate;
  mode.cycle_time_sync0 = cycle_of(dc->cycle_time0, bus_cycle);
  mode.shift_time_sync0.value_ns = dc->shift_time;
  if ((dc->assign_activate & kSync1) != 0) {
    mode.cycle_time_sync1 = cycle_of(dc->cycle_time0, bus_cycle);
    mode.shift_time_sync1.value_ns = dc->cycle_time1;
  }
  description.op_modes.push_back(std::move(mode));
  return description;
}

DcChoice recovered_dc_settings(const SlaveConfig& slave, const DeviceDescription& device, Nanoseconds bus_cycle) {
  DcChoice choice;
  const auto dc = dc_of(slave);
  if (!dc) return choice;
  choice.settings.potential_reference_clock = dc->potential_reference_clock;
  if (dc->assign_activate == 0) return choice;
  const DcOpMode* best = nullptr;
  const std::span<const DcOpMode> modes = device.dc ? std::span(device.dc->op_modes) : std::span<const DcOpMode>();
  for (const DcOpMode& mode : modes) {
    if (mode.assign_activate != dc->assign_activate) continue;
    DcSlaveSettings settings = choice.settings;
    settings.op_mode = mode.name;
    if (best == nullptr || sets(compiler::dc_times(mode, settings, bus_cycle), *dc)) {
      const bool first_that_fits = best == nullptr || !sets(compiler::dc_times(*best, settings, bus_cycle), *dc);
      if (first_that_fits) best = &mode;
    }
  }
  choice.exact = best != nullptr;
  if (best == nullptr) return choice;
  choice.settings.op_mode = best->name;
  set_times(choice.settings, *best, *dc, bus_cycle);
  return choice;
}

}  // namespace syncline::recover
