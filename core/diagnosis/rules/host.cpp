// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "diagnosis/rules/missed_events.h"
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"

namespace syncline::diagnosis {
namespace {

/// The least time that any slave with SYNC0 leaves a frame to be late. What one leaves whose SYNC0 is not where it was
/// meant to be is no measure of the host.
std::optional<Nanoseconds> least_margin(const RunReport& report) {
  std::optional<Nanoseconds> least;
  for (const auto& slave : report.slaves) {
    if (slave.sync0_margin && !slave.evidence.sync0.misplaced())
      least = std::min(least.value_or(*slave.sync0_margin), *slave.sync0_margin);
  }
  return least;
}

void find_lateness(const RunReport& report, Findings& findings) {
  const auto margin = least_margin(report);
  const auto& lateness = report.lateness_histogram;
  const auto p999 = lateness.percentile(0.999);
  const bool too_late = margin && p999 > *margin;
  // What keeps the reference clock from the external one is not the host.
  const bool by_host = report.dcm.state != SyncState::kInSync && !dc::is_of_external_clock(report.dcm.obstacle);
  const bool unlocked = report.dc.enabled && report.dcm.mode != DcmMode::kOff && !report.dcm.control_off && by_host &&
                        p999 > report.cycle_time / 10;
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

/// Who keeps a processor for less than this at a time is not who made cycles be left out.
constexpr Nanoseconds kNoticeable = 200 * kMicrosecond;

/// Who held the host, where its kernel tells how long the cyclic thread waited for others.
Finding stalled(const RunReport& report) {
  const auto& stalls = report.history.stalls;
  Finding finding{code::kHostStalled,
                  Severity::kWarning,
                  -1,
                  stalls.first(),
                  stalls.last(),
                  {times_figure("times", stalls.list().size()), count_figure("count", stalls.count()),
                   time_figure("longest", stalls.largest()), moment_figure(report, "since", stalls.first())}};
  const auto waited = report.host.held_by_others;
  if (!waited || report.host.held == 0) return finding;
  finding.code = 2 * *waited >= report.host.held ? code::kHostStalledByOthers : code::kHostTimerLate;
  if (finding.code == code::kHostStalledByOthers && report.host.holder.at_a_time >= kNoticeable) {
    finding.code = report.host.holder.kernel ? code::kHostHeldByKernel : code::kHostHeldByProgram;
    finding.figures.push_back(text_figure("thread", std::string(report.host.holder.name_text())));
    finding.figures.push_back(time_figure("slice", report.host.holder.at_a_time));
  }
  finding.figures.push_back(time_figure("held", report.host.held));
  finding.figures.push_back(time_figure("waited", *waited));
  return finding;
}

/// Before all are in OP cycles may be left out; it matters to those who are there already and fall by it, and where the
/// bus never came further because the clocks did not come in sync.
bool matters(const RunReport& report) {
  constexpr auto kLeftOut = static_cast<std::size_t>(dc::MissCause::kCyclesLeftOut);
  const bool waits_for_sync = report.dc.enabled && (report.dc.state != SyncState::kInSync ||
                                                    (is_controlled(report) && report.dcm.state != SyncState::kInSync));
  if (!report.history.reached_op && waits_for_sync) return true;
  return report.history.reached_op || std::ranges::any_of(report.slaves, [](const RunReport::Slave& slave) {
           return slave.sm2_missed && slave.sm2_missed->by_cause[kLeftOut] > 0;
         });
}

}  // namespace

void find_host(const RunReport& report, Findings& findings) {
  if (!report.history.stalls.empty() && matters(report)) findings.push_back(stalled(report));
  find_lateness(report, findings);
}

}  // namespace syncline::diagnosis
