// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/rules.h"

namespace syncline::diagnosis {

void find_working_counters(const RunReport& report, Findings& findings) {
  const auto& wrong = report.history.wrong_counters;
  std::uint64_t explained = 0, other = 0;
  int slave = -1;
  for (const auto& spell : wrong.list()) {
    const auto trouble = slave_in_trouble(report, spell);
    if (slave < 0) slave = trouble;
    (trouble >= 0 ? explained : other) += spell.count;
  }
  if (other > 0) {
    findings.push_back(
        {code::kWorkingCounter,
         Severity::kWarning,
         -1,
         wrong.first(),
         wrong.last(),
         {count_figure("count", other), count_figure("received", report.history.counter_received),
          count_figure("expected", report.history.counter_expected), moment_figure(report, "since", wrong.first())}});
  }
  if (explained > 0) {
    findings.push_back({code::kWorkingCounterExplained,
                        Severity::kNote,
                        -1,
                        wrong.first(),
                        wrong.last(),
                        {count_figure("count", explained), moment_figure(report, "since", wrong.first()),
                         slave_figure(report, slave)}});
  }
}

}  // namespace syncline::diagnosis
