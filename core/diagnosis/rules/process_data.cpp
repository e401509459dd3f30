// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "protocol/al_state.h"
#include "protocol/diagnosis_message.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {

namespace {

/// It was never right in OP, as far as anybody has looked, although everybody is there.
bool is_never_right(const RunReport& report, const Spells& wrong) {
  constexpr Nanoseconds kNewest = 500 * kMillisecond;
  const auto cycles = report.cycle_time > 0 ? (report.history.end - wrong.first()) / report.cycle_time : 0;
  const bool all_in_op = std::ranges::all_of(report.slaves, [](const RunReport::Slave& slave) {
    return slave.optional || (slave.present && al_state_of(slave.al_status) == AlState::kOp);
  });
  // One in ten may be lost, or belong to a slower task.
  return report.history.reached_op && all_in_op && wrong.last() + kNewest >= report.history.end &&
         10 * wrong.count() >= 9 * static_cast<std::uint64_t>(std::max<Nanoseconds>(cycles, 1)) && cycles >= 100;
}

}  // namespace

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
    const bool never_right = is_never_right(report, other);
    findings.push_back(
        {never_right ? code::kWorkingCounterNeverRight : code::kWorkingCounter,
         never_right ? Severity::kError : Severity::kWarning,
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
