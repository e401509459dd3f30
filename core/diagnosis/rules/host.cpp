// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "diagnosis/rules/rules.h"

namespace syncline::diagnosis {
namespace {

/// The least time that any slave with SYNC0 leaves a frame to be late.
std::optional<Nanoseconds> least_margin(const RunReport& report) {
  std::optional<Nanoseconds> least;
  for (const auto& slave : report.slaves) {
    if (slave.sync0_margin) least = std::min(least.value_or(*slave.sync0_margin), *slave.sync0_margin);
  }
  return least;
}

void find_lateness(const RunReport& report, Findings& findings) {
  const auto margin = least_margin(report);
  const auto& lateness = report.lateness_histogram;
  const auto p999 = lateness.percentile(0.999);
  const bool too_late = margin && p999 > *margin;
  const bool unlocked = report.dc.enabled && report.dcm.mode != DcmMode::kOff && !report.dcm.control_off &&
                        report.dcm.state != SyncState::kInSync && p999 > report.cycle_time / 10;
  if (!too_late && !unlocked) return;
  findings.push_back({code::kHostLate,
                      Severity::kWarning,
                      -1,
                      0,
                      0,
                      {time_figure("p50", lateness.percentile(0.5)), time_figure("p99", lateness.percentile(0.99)),
                       time_figure("p999", p999), time_figure("largest", lateness.max()),
                       time_figure("margin", margin.value_or(report.cycle_time))}});
}

}  // namespace

void find_host(const RunReport& report, Findings& findings) {
  const auto& stalls = report.history.stalls;
  if (!stalls.empty() && report.history.reached_op) {
    findings.push_back({code::kHostStalled,
                        Severity::kWarning,
                        -1,
                        stalls.first(),
                        stalls.last(),
                        {times_figure("times", stalls.list().size()), count_figure("count", stalls.count()),
                         time_figure("longest", stalls.largest()), moment_figure(report, "since", stalls.first())}});
  }
  find_lateness(report, findings);
}

}  // namespace syncline::diagnosis
