// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "channels/mailbox_silence.h"
#include "diagnosis/rules/moved_clocks.h"
#include "diagnosis/rules/rules.h"
#include "families/device_family.h"
#include "families/families.h"
#include "findings/run_codes.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

void find_exceeded(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const auto& evidence = slave.evidence;
  const bool outputs = evidence.outputs.exceeded.total >= evidence.inputs.exceeded.total;
  const auto& counted = outputs ? evidence.outputs.exceeded : evidence.inputs.exceeded;
  if (counted.total == 0) return;
  const auto& history = report.history.slaves[slave.position];
  const auto& spells = outputs ? history.outputs_exceeded : history.inputs_exceeded;
  // A SYNC0 that comes early cuts the cycle before it short: the clock's doing, told as that.
  if (sync0_had_moved(report, slave, spells)) return;
  const auto counters = families::sync_counters(slave.identity).value_or(families::SyncCounters{});
  const auto object =
      fmt::format("0x{:04X}:{:02X}", outputs ? families::kOutputSync : families::kInputSync, counters.cycle_exceeded);
  const auto* family = families::find(slave.identity);
  const bool gateway = family != nullptr && family->gateway;
  if (const auto by_frames = (outputs ? evidence.outputs : evidence.inputs).by_frames; 2 * by_frames >= counted.total) {
    findings.push_back({code::kExceededByHost,
                        Severity::kWarning,
                        slave.position,
                        spells.first(),
                        spells.last(),
                        {slave_figure(report, slave.position), count_figure("count", counted.total, counted.at_least),
                         text_figure("object", object), moment_figure(report, "last", spells.last())}});
    return;
  }
  findings.push_back({gateway ? code::kGatewayCycleExceeded : code::kFirmwareSlow,
                      Severity::kWarning,
                      slave.position,
                      spells.first(),
                      spells.last(),
                      {slave_figure(report, slave.position),
                       gateway ? count_figure("count", counted.total, counted.at_least)
                               : times_figure("count", counted.total, counted.at_least),
                       text_figure("object", object), moment_figure(report, "last", spells.last())}});
}

/// Where the slave counts it itself, or hangs, that says more.
void find_late_data(const RunReport& report, const RunReport::Slave& slave, bool outputs, Findings& findings) {
  const auto& history = report.history.slaves[slave.position];
  const auto& late = outputs ? history.late_outputs : history.late_inputs;
  const bool counted = slave.evidence.outputs.exceeded.total > 0 || slave.evidence.inputs.exceeded.total > 0;
  if (late.empty() || counted || !history.pdi_watchdog.empty()) return;
  findings.push_back({outputs ? code::kOutputsLate : code::kInputsLate,
                      Severity::kWarning,
                      slave.position,
                      late.first(),
                      late.last(),
                      {slave_figure(report, slave.position), moment_figure(report, "since", late.first()),
                       times_figure("count", late.count())}});
}

/// It has answered nothing since: what stood still stands still.
bool still_hangs(const RunReport& report, const RunHistory::Slave& slave) {
  constexpr Nanoseconds kAsked = 3 * kSecond;  // of a slave that answers nothing, again and again
  return slave.mailbox_silences >= kMailboxSilentAfter && slave.silent_to >= slave.pdi_watchdog.last() &&
         slave.silent_to + kAsked >= report.history.end;
}

void find_watchdogs(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const auto& history = report.history.slaves[slave.position];
  if (!history.pdi_watchdog.empty()) {
    const auto& hung = history.pdi_watchdog;
    const bool still = slave.present && (slave.evidence.pdi_silent || still_hangs(report, history));
    findings.push_back({still ? code::kFirmwareHangs : code::kFirmwareHung,
                        still ? Severity::kError : Severity::kWarning,
                        slave.position,
                        hung.first(),
                        hung.last(),
                        {slave_figure(report, slave.position), moment_figure(report, "since", hung.first()),
                         times_figure("count", hung.count(), slave.evidence.pdi_watchdog.at_least)}});
  }
  const auto& outputs = history.process_data_watchdog;
  // Outputs that could not come: the cause is told already.
  const bool was_cut_off = std::ranges::all_of(outputs.list(), [&](const Spell& spell) {
    const Spell before{spell.from - kReadLater, spell.to, 0, 0};
    return adapter_was_away(report, before) || history.absences.near(spell, kReadLater) ||
           history.recoveries.near(before, 0) ||  // led up from INIT
           report.history.stalls.near(before, 0);
  });
  if (!outputs.empty() && report.history.reached_op && !was_cut_off) {
    findings.push_back({code::kOutputsWatchdog,
                        Severity::kWarning,
                        slave.position,
                        outputs.first(),
                        outputs.last(),
                        {slave_figure(report, slave.position), times_figure("count", outputs.count()),
                         moment_figure(report, "last", outputs.last())}});
  }
}

}  // namespace

void find_firmware(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    find_watchdogs(report, slave, findings);
    find_exceeded(report, slave, findings);
    for (const bool outputs : {false, true}) find_late_data(report, slave, outputs, findings);
    const auto& history = report.history.slaves[slave.position];
    if (slave.present && history.mailbox_silences >= kMailboxSilentAfter) {
      findings.push_back({code::kMailboxSilent,
                          Severity::kWarning,
                          slave.position,
                          history.silent_from,
                          history.silent_to,
                          {slave_figure(report, slave.position), count_figure("count", history.mailbox_silences)}});
    }
  }
}

}  // namespace syncline::diagnosis
