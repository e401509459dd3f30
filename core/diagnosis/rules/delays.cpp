// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

/// The delay that was taken in place of the measured one is that of the slave before it. Another one was measured
/// since.
bool was_measured_since(const RunReport& report, const RunReport::Slave& slave) {
  constexpr std::uint32_t kHop = 100;  // ns, less than any way takes
  if (slave.parent < 0 || !slave.propagation_delay_ns) return false;
  const auto& before = report.slaves[static_cast<std::size_t>(slave.parent)].propagation_delay_ns;
  return before && *slave.propagation_delay_ns >= *before + kHop;
}

}  // namespace

/// A verdict on clocks stands on the delays that were measured: where one is wrong, 0x092C is near zero all the same.
void find_delays(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    const auto& trouble = report.history.slaves[slave.position].delay;
    if (!trouble || !slave.present || was_measured_since(report, slave)) continue;
    findings.push_back({code::kDelayNotMeasured,
                        Severity::kError,
                        slave.position,
                        trouble->time,
                        report.history.end,
                        {slave_figure(report, slave.position), time_figure("delay", trouble->measured)}});
  }
}

}  // namespace syncline::diagnosis
