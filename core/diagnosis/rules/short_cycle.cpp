// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/frame_time.h"
#include "diagnosis/rules/rules.h"
#include "findings/project_master_words.h"
#include "findings/run_codes.h"
#include "findings/sentence.h"
#include "protocol/al_state.h"
#include "protocol/frame.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

/// The master waits for its frames until 95 % of the cycle are over, and needs 5 % and room for one request beside them
/// to do something else than exchange data.
constexpr Nanoseconds kShare = 90;  // percent
constexpr Nanoseconds kRequest = wire_time_ns(kMinEthernetFrame);
constexpr std::string_view kConsequences[] = {code::kSlaveBehind, code::kFramesLate, code::kHostLate};

bool somebody_is_behind(const RunReport& report) {
  AlState highest = AlState::kNone;
  for (const auto& slave : report.slaves) highest = std::max(highest, al_state_of(slave.al_status));
  return std::ranges::any_of(report.slaves, [&](const RunReport::Slave& slave) {
    return !slave.optional && (!slave.present || al_state_of(slave.al_status) < highest);
  });
}

/// From the first byte that leaves until the last one is back. Where none came back in time: no shorter than they were
/// late.
Nanoseconds needed(const RunReport& report) {
  if (report.round_trip) return report.wire_time + *report.round_trip - report.first_wire_time;
  const auto& late = report.history.late_frames;
  return report.late_frames * 2 < report.cycles
             ? 0
             : std::max(report.wire_time, latest_return(report.cycle_time) + late.largest());
}

/// Nobody was ever heard because every frame came too late.
bool is_unheard(const RunReport& report, const Finding& finding) {
  const bool absent = finding.code == code::kSlaveAbsent || finding.code == code::kSlaveAbsentBehindCable;
  return absent && finding.place.slave == 0 && !report.round_trip;
}

}  // namespace

void find_short_cycle(const RunReport& report, Findings& findings) {
  if (report.cycle_time <= 0 || report.wire_time <= 0 || report.cycles == 0) return;
  const auto time = needed(report);
  if (time + kRequest < report.cycle_time * kShare / 100) return;
  if (report.late_frames == 0 && !somebody_is_behind(report)) return;
  std::erase_if(findings, [&](const Finding& finding) {
    return std::ranges::find(kConsequences, finding.code) != std::end(kConsequences) || is_unheard(report, finding);
  });
  findings.push_back(make_finding<words::kProjectMaster>(
      "cycle-too-short/run", {}, fig::time<"cycle">(report.cycle_time), Named<"needed">{time_figure("needed", time)},
      fig::time<"wire">(report.wire_time),
      Named<"travel">{time_figure("travel", std::max<Nanoseconds>(time - report.wire_time, 0))},
      fig::count<"slaves">(report.slaves.size()), fig::count<"late">(report.late_frames)));
  // Before what it may be the cause of. Not std::ranges::rotate: clang 14 cannot compile what libstdc++ 12 makes of it.
  std::rotate(findings.begin(), findings.end() - 1, findings.end());
}

}  // namespace syncline::diagnosis
