// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "dc/dcm/dcm_controller.h"
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "findings/sentence.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

/// What a shaken reference clock looks like to the slaves.
constexpr std::array kSigns{code::kSlavesOutOfSync, code::kSlaveLeftWindow, code::kWindowLeft};
/// Of what one frame is off its usual place the clock's own loop lets through no more than this part in a millisecond:
/// of a desktop's tails of 0.4 ms some 5 us. In a longer cycle it follows the wrong time for longer.
constexpr Nanoseconds kThrough = 64;

std::int64_t size_of(const Finding& finding, std::string_view name) {
  const auto figure = std::ranges::find(finding.figures, name, &Figure::name);
  return figure == finding.figures.end() ? 0 : std::abs(figure->value);
}

/// Slaves or the master are off, and by no more than jitter of this size, ns, can make them: who is off by more is off
/// for another reason. Of a frame's lateness the clock is told all but a little; how wrong the stamp is nobody knows.
bool is_shaken(const RunReport& report, const Findings& findings, Nanoseconds most) {
  const auto told = std::min(most, dc::kMostShakenByNominal) + report.history.largest_stamp_doubt;
  const auto through = told * std::max(report.cycle_time, kMillisecond) / (kThrough * kMillisecond);
  const bool slaves = std::ranges::any_of(findings, [&](const Finding& finding) {
    const bool sign = std::ranges::find(kSigns, finding.code) != kSigns.end();
    return sign && size_of(finding, "deviation") <= through;
  });
  const bool never_locked = std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.code == code::kMasterNotLocked && size_of(finding, "error") <= most;
  });
  return slaves || never_locked ||
         std::ranges::any_of(report.history.master_losses, [&](const RunHistory::SyncLoss& loss) {
           return loss.obstacle == dc::SyncObstacle::kControlError && std::abs(loss.size) <= most;
         });
}

}  // namespace

void find_clock_jitter(const RunReport& report, Findings& findings) {
  if (!report.dc.enabled || report.dcm.mode != DcmMode::kMasterRefClock || report.dcm.control_off) return;
  const auto& lateness = report.lateness_histogram;
  const bool measured = lateness.count() > 0;
  if (!is_shaken(report, findings, measured ? lateness.max() : INT64_MAX)) return;
  Finding finding{code::kJitterReachesClock, Severity::kWarning};
  if (measured) {
    finding.figures = {time_figure("p50", lateness.percentile(0.5)), time_figure("p99", lateness.percentile(0.99)),
                       time_figure("p999", lateness.percentile(0.999)), time_figure("largest", lateness.max())};
    finding.facts = sentence_of(*find_finding_words(code::kJitterReachesClock), "measured");
  }
  findings.push_back(std::move(finding));
}

}  // namespace syncline::diagnosis
