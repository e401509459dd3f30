// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/run_diagnosis.h"

#include <algorithm>

#include "diagnosis/rules/rules.h"
#include "trace/run_report.h"

namespace syncline {

std::vector<Finding> diagnose(const RunReport& report) {
  std::vector<Finding> findings;
  for (const auto rule :
       {diagnosis::find_link_outages, diagnosis::find_absent_slaves, diagnosis::find_states, diagnosis::find_clocks,
        diagnosis::find_delays, diagnosis::find_late_writes, diagnosis::find_master_sync,
        diagnosis::find_misplaced_sync0, diagnosis::find_missed_outputs, diagnosis::find_tight_sync0,
        diagnosis::find_firmware, diagnosis::find_port_errors, diagnosis::find_foreign_frames,
        diagnosis::find_lost_frames, diagnosis::find_host, diagnosis::find_clock_jitter,
        diagnosis::find_working_counters, diagnosis::find_short_cycle}) {
    rule(report, findings);
  }
  std::ranges::stable_sort(findings, [](const Finding& x, const Finding& y) { return x.severity > y.severity; });
  return findings;
}

}  // namespace syncline
