// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "findings/sentence.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

/// What a shaken reference clock looks like, and how far off somebody was.
constexpr std::array kSigns{code::kSlavesOutOfSync, code::kSlaveLeftWindow, code::kWindowLeft, code::kMasterNotLocked,
                            code::kMasterLostLock};

/// What one frame is off its usual place reaches the clock through its own loop, a part of it only: who is off by more
/// than any frame was is off for another reason.
bool is_within(const Finding& finding, Nanoseconds most) {
  const auto figure = std::ranges::find(finding.figures, "deviation", &Figure::name);
  return figure == finding.figures.end() || figure->value <= most;
}

}  // namespace

void find_clock_jitter(const RunReport& report, Findings& findings) {
  if (!report.dc.enabled || report.dcm.mode != DcmMode::kMasterRefClock || report.dcm.control_off) return;
  const auto& lateness = report.lateness_histogram;
  const bool measured = lateness.count() > 0;
  const bool shaken = std::ranges::any_of(findings, [&](const Finding& finding) {
    const bool sign = std::ranges::find(kSigns, finding.code) != kSigns.end();
    return sign && (!measured || is_within(finding, lateness.max()));
  });
  if (!shaken) return;
  Finding finding{code::kJitterReachesClock, Severity::kWarning};
  if (measured) {
    finding.figures = {time_figure("p50", lateness.percentile(0.5)), time_figure("p99", lateness.percentile(0.99)),
                       time_figure("p999", lateness.percentile(0.999)), time_figure("largest", lateness.max())};
    finding.facts = sentence_of(*find_finding_words(code::kJitterReachesClock), "measured");
  }
  findings.push_back(std::move(finding));
}

}  // namespace syncline::diagnosis
