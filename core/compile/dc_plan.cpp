// SPDX-License-Identifier: Apache-2.0
#include "compile/dc_plan.h"

#include <algorithm>

#include "compile/slave_plan.h"
#include "config/dc_description.h"
#include "config/dc_settings.h"
#include "config/project.h"
#include "config/slave_config.h"
#include "config/sync0_cycle.h"

namespace syncline::compiler {
namespace {

/// A coupler or junction whose ESI declares a clock and no SYNC signals (Dc@TimeLoopControlOnly): it has no
/// op mode to choose, and follows or leads wherever DC is used at all.
bool is_clock_only(const SlavePlan& slave) {
  return slave.device().dc && slave.device().dc->time_loop_control_only && slave.device().dc->op_modes.empty();
}

}  // namespace

std::optional<std::uint16_t> resolve_reference_clock(const Project& project, std::span<const SlavePlan> slaves) {
  const auto& settings = project.master.dc;
  const auto has_clock = [](const SlavePlan& slave) { return slave.device().dc.has_value(); };
  const bool used = std::ranges::any_of(slaves, &SlavePlan::dc_commands) ||
                    (settings.all_slaves && std::ranges::any_of(slaves, has_clock));
  if (!settings.enabled || !used) {
    return std::nullopt;
  }
  if (settings.first_slave_is_reference_clock) {
    return std::ranges::find_if(slaves, has_clock)->position;
  }
  const auto chosen = settings.reference_clock;
  if (chosen && *chosen < slaves.size() && slaves[*chosen].device().dc) {
    return chosen;
  }
  // The first that takes part in DC: those before it could not be synchronised by it.
  return std::ranges::find_if(slaves,
                              [&](const SlavePlan& slave) {
                                return slave.dc_commands() || is_clock_only(slave) ||
                                       (settings.all_slaves && has_clock(slave));
                              })
      ->position;
}

void plan_dc(const Project& project, std::span<SlavePlan> slaves) {
  if (!project.master.dc.enabled) {
    return;
  }
  for (SlavePlan& slave : slaves) {
    const DcSlaveSettings& user = slave.settings->dc;
    const DcOpMode* mode = selected_op_mode(*slave.settings);
    if (mode != nullptr && mode->assign_activate != 0) {
      const DcTimes times = dc_times(*mode, user, slave.cycle_time, project.master.dc.input_shift);
      slave.dc = SlaveDcConfig{.potential_reference_clock = user.potential_reference_clock,
                               .reference_clock = false,
                               .cycle_time0 = times.cycle_time0,
                               .cycle_time1 = times.cycle_time1,
                               .shift_time = times.shift_time,
                               .assign_activate = mode->assign_activate};
    } else if (user.potential_reference_clock && slave.device().dc) {
      slave.dc = SlaveDcConfig{.potential_reference_clock = true};
    }
  }
  if (project.master.dc.all_slaves) {
    for (SlavePlan& slave : slaves) {
      if (!slave.dc && slave.device().dc) {
        slave.dc = SlaveDcConfig{};
      }
    }
  }
  if (std::ranges::any_of(slaves, &SlavePlan::dc_commands)) {
    for (SlavePlan& slave : slaves) {
      if (!slave.dc && is_clock_only(slave)) {
        slave.dc = SlaveDcConfig{.potential_reference_clock = slave.settings->dc.potential_reference_clock};
      }
    }
  }
  if (const auto clock = resolve_reference_clock(project, slaves)) {
    auto& dc = slaves[*clock].dc;
    if (!dc) {
      dc.emplace();
    }
    dc->reference_clock = true;
  }
}

DcMasterSettings run_time_dc(const Project& project, std::span<const SlavePlan> slaves) {
  DcMasterSettings dc = project.master.dc;
  dc.reference_clock = resolve_reference_clock(project, slaves);
  dc.enabled = dc.reference_clock.has_value();
  if (!dc.enabled) {
    dc.dcm.mode = DcmMode::kOff;
    dc.sync_window.enabled = false;
  }
  return dc;
}

}  // namespace syncline::compiler
