// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/rules.h"

namespace syncline::diagnosis {

void find_working_counters(const RunReport& report, Findings& findings) {
  const auto& wrong = report.history.wrong_counters;
  Spells explained, other;
  int slave = -1;
  for (const auto& spell : wrong.list()) {
    const auto trouble = slave_in_trouble(report, spell);
    if (slave < 0) slave = trouble;
    (trouble >= 0 ? explained : other).note(spell.to, spell.count, 0, spell.from);
  }
  if (!other.empty()) {
    findings.push_back(
        {code::kWorkingCounter,
         Severity::kWarning,
         -1,
         other.first(),
         other.last(),
         {count_figure("count", other.count()), count_figure("received", report.history.counter_received),
          count_figure("expected", report.history.counter_expected), moment_figure(report, "since", other.first())}});
  }
  if (!explained.empty()) {
    findings.push_back({code::kWorkingCounterExplained,
                        Severity::kNote,
                        -1,
                        explained.first(),
                        explained.last(),
                        {count_figure("count", explained.count()), moment_figure(report, "since", explained.first()),
                         slave_figure(report, slave)}});
  }
}

}  // namespace syncline::diagnosis
