// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/run_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace syncline {
namespace {

constexpr double kMaxDriftPpm = 600;  // beyond it no controller balances (EC-Master 0x981201CA)

using Severity = DiagnosisSeverity;
using Code = DiagnosisCode;
using Findings = std::vector<DiagnosisFinding>;

bool in_error(const RunReport::Slave& slave) { return (slave.al_status & kAlErrorFlag) != 0; }

void check_states(const RunReport& report, Findings& findings) {
  AlState highest = AlState::kNone;
  for (const auto& slave : report.slaves) highest = std::max(highest, al_state_of(slave.al_status));
  for (const auto& slave : report.slaves) {
    if (in_error(slave)) {
      findings.push_back({Code::kSlaveError, Severity::kError, slave.position, slave.al_status, slave.al_status_code});
    } else if (al_state_of(slave.al_status) < highest) {
      findings.push_back({Code::kSlaveLeftState, Severity::kWarning, slave.position, slave.al_status, 0});
    }
  }
}

void check_clocks(const RunReport& report, Findings& findings) {
  if (!report.dc.enabled) return;
  if (!report.dc.monitored) {
    findings.push_back({Code::kNotMonitored, Severity::kNote});
  } else if (report.dc.state != SyncState::kInSync) {
    DiagnosisFinding finding{Code::kSlavesOutOfSync, Severity::kError, -1, 0, report.dc.limit_ns};
    for (const auto& slave : report.slaves) {
      const std::int64_t deviation = std::abs(slave.deviation_ns.value_or(0));
      if (deviation > finding.a) {
        finding.slave = slave.position;
        finding.a = deviation;
      }
    }
    findings.push_back(finding);
  }
  const auto& dcm = report.dcm;
  if (dcm.mode == DcmMode::kOff) return;
  if (std::abs(dcm.drift_ppm) > kMaxDriftPpm) {
    findings.push_back({Code::kDriftTooHigh, Severity::kError, -1, std::llround(dcm.drift_ppm)});
  } else if (dcm.state != SyncState::kInSync && !dcm.control_off) {
    findings.push_back({Code::kMasterNotLocked, Severity::kError, -1, dcm.error_ns});
  }
}

void check_sm2(const RunReport& report, Findings& findings) {
  const bool locked = report.dcm.mode != DcmMode::kOff && report.dcm.state == SyncState::kInSync;
  for (const auto& slave : report.slaves) {
    if (!slave.sm2_missed || slave.sm2_missed->value == 0) continue;
    findings.push_back({locked ? Code::kSm2MissedLocked : Code::kSm2MissedUnlocked, Severity::kWarning, slave.position,
                        slave.sm2_missed->value});
  }
}

void check_counters(const RunReport& report, Findings& findings) {
  const auto add = [&findings](Code code, std::uint64_t count) {
    if (count > 0) findings.push_back({code, Severity::kWarning, -1, static_cast<std::int64_t>(count)});
  };
  add(Code::kWorkingCounter, report.wkc_errors);
  add(Code::kFramesLost, report.lost_frames);
  add(Code::kOverruns, report.overruns);
}

}  // namespace

std::vector<DiagnosisFinding> diagnose(const RunReport& report) {
  Findings findings;
  check_states(report, findings);
  check_clocks(report, findings);
  check_sm2(report, findings);
  check_counters(report, findings);
  std::stable_sort(findings.begin(), findings.end(), [](const auto& x, const auto& y) { return x.severity > y.severity; });
  return findings;
}

std::string describe(const DiagnosisFinding& f) {
  switch (f.code) {
    case Code::kSlaveError: {
      const auto text = al_status_code_text(static_cast<std::uint16_t>(f.b));
      return fmt::format("Slave {} is in {} with AL status code 0x{:04X} ({}); check {}.", f.slave,
                         al_state_name(al_state_of(static_cast<std::uint16_t>(f.a))), f.b, text.meaning, text.check);
    }
    case Code::kSlaveLeftState:
      return fmt::format("Slave {} stays in {} while others went further; request the state again and watch its AL status.",
                         f.slave, al_state_name(al_state_of(static_cast<std::uint16_t>(f.a))));
    case Code::kNotMonitored:
      return "The slaves' deviation is not monitored; switch sync window monitoring on to prove that they are in sync.";
    case Code::kSlavesOutOfSync:
      return f.slave < 0 ? fmt::format("The slaves are not in sync within {} ns.", f.b)
                         : fmt::format("The slaves are not in sync: slave {} is {} ns off, the limit is {} ns; a clock that "
                                       "was not initialised or cannot follow stands out here.", f.slave, f.a, f.b);
    case Code::kMasterNotLocked:
      return fmt::format("The master is not locked to the reference clock (error {} ns); frames slide through the SYNC0 "
                         "grid. Look for a busy host, or choose the other shift mode.", f.a);
    case Code::kDriftTooHigh:
      return fmt::format("The host's clock and the reference clock drift by {} ppm; no controller balances more than 600. "
                         "Check the cycle time and the host's timer frequency.", f.a);
    case Code::kSm2MissedUnlocked:
      return fmt::format("Slave {} missed {} SM2 events while the master is not locked: that is the cause to mend first.",
                         f.slave, f.a);
    case Code::kSm2MissedLocked:
      return fmt::format("Slave {} missed {} SM2 events although the master is locked: frames come too close to SYNC0. Move "
                         "SYNC0 (set value or shift), or make the host less late.", f.slave, f.a);
    case Code::kWorkingCounter:
      return fmt::format("{} cycles had a wrong working counter: a slave left OP, lost its link or did not serve its data.", f.a);
    case Code::kFramesLost:
      return fmt::format("{} frames did not come back: cable, plug or noise; compare the ports' error counters.", f.a);
    case Code::kOverruns:
      return fmt::format("{} cycles began more than a cycle late: the host was busy with something else.", f.a);
  }
  return {};
}

}  // namespace syncline
