// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/rules.h"

namespace syncline::diagnosis {
namespace {

using Code = FindingCode;

void find_shift_too_short(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const auto& outputs = slave.evidence.outputs.shift_too_short;
  if (outputs.total > 0) {
    const auto margin = slave.sync0_margin.value_or(0);
    const Nanoseconds need = slave.evidence.calc_and_copy_ns;
    const auto more = advised(need - margin + usual_worst_lateness(report));
    findings.push_back({Code::kShiftTooShort,
                        FindingLevel::kWarning,
                        slave.position,
                        0,
                        outputs.time,
                        {slave_figure(report, slave.position), times_figure("count", outputs.total, outputs.at_least),
                         time_figure("margin", margin), time_figure("need", need), time_figure("more", more),
                         time_figure("shift", slave.sync0_shift + more)}});
  }
  const auto& inputs = slave.evidence.inputs.shift_too_short;
  if (inputs.total > 0) {
    findings.push_back({Code::kInputShiftTooShort,
                        FindingLevel::kWarning,
                        slave.position,
                        0,
                        inputs.time,
                        {slave_figure(report, slave.position), times_figure("count", inputs.total, inputs.at_least)}});
  }
}

/// Known before anything is missed: the usual lateness does not fit between frame and SYNC0.
void find_too_tight(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const bool locked = report.dcm.mode != DcmMode::kOff && report.dcm.state == SyncState::kInSync;
  const bool told = slave.sm2_missed && slave.sm2_missed->missed > 0;
  const auto lateness = usual_worst_lateness(report);
  constexpr std::uint64_t kEnough = 1000;
  if (!slave.sync0_margin || told || !locked || report.history.frame_lateness.count() < kEnough) return;
  if (lateness <= *slave.sync0_margin) return;
  findings.push_back(
      {Code::kSync0TooTight,
       FindingLevel::kWarning,
       slave.position,
       0,
       0,
       {slave_figure(report, slave.position), time_figure("margin", *slave.sync0_margin),
        time_figure("lateness", lateness),
        time_figure("more", advised(lateness + slave.evidence.calc_and_copy_ns - *slave.sync0_margin))}});
}

}  // namespace

void find_tight_sync0(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    find_shift_too_short(report, slave, findings);
    find_too_tight(report, slave, findings);
  }
}

}  // namespace syncline::diagnosis
