// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "check/network_view.h"
#include "compile/cyclic_frames.h"
#include "config/command_text.h"
#include "config/frame_time.h"
#include "protocol/registers.h"
#include "settings/limits.h"

namespace syncline::checker {
namespace {

constexpr std::uint32_t kShortestStateTimeout = 100;  // ms

void check_timeouts(const NetworkView& view, Findings& findings) {
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const auto& commands = view.config.slaves[i].init_cmds;
    for (std::size_t c = 0; c < commands.size(); ++c) {
      if (!commands[c].validate) continue;
      const std::uint32_t timeout = commands[c].validate->timeout_ms;
      const ConfigPlace place{PlaceKind::kSlaveInitCmd, i, c};
      if (timeout == 0) {
        findings.add("ENI-TIME-01", place, fig::text<"command">(address_text(commands[c])));
      } else if (commands[c].ado == reg::kAlStatus && timeout < kShortestStateTimeout) {
        findings.add("ENI-TIME-02", place, fig::count<"timeout">(timeout));
      }
    }
  }
}

void check_load(const NetworkView& view, std::size_t t, Findings& findings) {
  const CyclicTask& task = view.config.cyclic[t];
  const ConfigPlace place{PlaceKind::kTask, t};
  Nanoseconds wire = 0;
  for (const auto& frame : task.frames) wire += wire_time(frame);
  const std::size_t slaves = view.config.slaves.size();
  const auto travel = wire > 0 ? travel_time(view.config) : 0;
  const auto frames = fig::count<"frames">(task.frames.size());
  const auto taken = fig::time<"wire">(wire);
  const auto cycle = fig::time<"cycle">(task.cycle_time);
  if (wire > task.cycle_time) {
    findings.add("ENI-TIME-03", place, frames, taken, cycle);
  } else if (wire + travel > task.cycle_time) {
    findings.add("ENI-TIME-08", place, frames, taken, fig::time<"travel">(travel), fig::count<"slaves">(slaves), cycle);
  } else if (wire > task.cycle_time / 10 * 8) {
    findings.add("ENI-TIME-04", place, frames, taken, cycle);
  }
}

void check_cycles(const NetworkView& view, Findings& findings) {
  const auto& tasks = view.config.cyclic;
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    if (!tasks[t].cycle_time_given) continue;
    if (tasks[t].cycle_time < limits::kShortestCycle || tasks[t].cycle_time > limits::kLongestTaskCycle) {
      findings.add("ENI-TIME-05", {PlaceKind::kTask, t}, fig::time<"cycle">(tasks[t].cycle_time));
      continue;
    }
    check_load(view, t, findings);
    const Nanoseconds base = tasks.front().cycle_time;
    if (tasks.front().cycle_time_given && base > 0 && tasks[t].cycle_time % base != 0) {
      findings.add("ENI-TIME-06", {PlaceKind::kTask, t}, fig::time<"cycle">(tasks[t].cycle_time),
                   fig::time<"first">(base));
    }
  }
}

}  // namespace

void check_times(const NetworkView& view, Findings& findings) {
  check_timeouts(view, findings);
  check_cycles(view, findings);
}

}  // namespace syncline::checker
