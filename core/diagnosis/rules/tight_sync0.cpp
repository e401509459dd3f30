// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "diagnosis/rules/missed_events.h"
#include "diagnosis/rules/moved_clocks.h"
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"

namespace syncline::diagnosis {
namespace {

/// Frames that are on time leave it less than it needs: each cycle uses outputs of the one before.
bool nominally_too_short(const RunReport::Slave& slave) {
  return slave.sync0_margin && slave.evidence.calc_and_copy_ns > *slave.sync0_margin;
}

bool is_found(const Findings& findings, const RunReport::Slave& slave, std::string_view code) {
  return std::ranges::any_of(
      findings, [&](const Finding& finding) { return finding.place.slave == slave.position && finding.code == code; });
}

/// It counts outputs that came too late for SYNC0 where it misses them altogether: one cause, which is told with more.
bool misses_told(const Findings& findings, const RunReport::Slave& slave) {
  return is_found(findings, slave, code::kSlaveFellByLateFrames) ||
         is_found(findings, slave, code::kMissedByLateFrames) || is_found(findings, slave, code::kMissedUnlocked);
}

/// Each time with an event that it missed by frames that were held up, or that a host did not send: told as that, and
/// no place of SYNC0 is later than these.
bool came_with_misses(const RunReport& report, const Findings& findings, const RunReport::Slave& slave) {
  if (!is_found(findings, slave, code::kMissedByHeldFrames) && !is_found(findings, slave, code::kMissedByHost))
    return false;
  const auto& history = report.history.slaves[slave.position];
  const auto& times = history.shift_too_short.list();
  return !times.empty() &&
         std::ranges::all_of(times, [&](const Spell& spell) { return history.missed.near(spell, kToldLater); });
}

/// What it missed in thousands of cycles that were all late is the least of it. A fall by late frames is not: it says
/// by how much they were late, and asks for that and what the slave needs.
bool is_mostly_late(const RunReport& report, const RunReport::Slave& slave, const Findings& findings) {
  constexpr std::uint64_t kFarMore = 10;
  const bool locked = was_locked(report, slave, report.history.slaves[slave.position].shift_too_short);
  if (!locked || !nominally_too_short(slave) || !slave.sm2_missed) return false;
  const auto times = slave.evidence.outputs.shift_too_short.total;
  return times >= kFarMore * slave.sm2_missed->total() && !is_found(findings, slave, code::kSlaveFellByLateFrames);
}

/// It fell by misses where frames slid through its SYNC0: its finding says so.
bool fell_unlocked(const RunReport& report, const Findings& findings, const RunReport::Slave& slave) {
  return !was_locked(report, slave, report.history.slaves[slave.position].missed) &&
         is_found(findings, slave, code::kSlaveFellByMisses);
}

/// Frames that slide through SYNC0 are too late for it now and then, wherever it is.
Finding slid(const RunReport& report, const RunReport::Slave& slave) {
  const auto& outputs = slave.evidence.outputs.shift_too_short;
  Finding finding{code::kMissedUnlocked, Severity::kWarning, slave.position,
                  report.history.slaves[slave.position].shift_too_short.first(), outputs.time};
  finding.figures = {slave_figure(report, slave.position), times_figure("count", outputs.total, outputs.at_least)};
  finding.facts = sentence_of(*find_finding_words(code::kMissedUnlocked), "late");
  return finding;
}

Finding came_held(const RunReport& report, const RunReport::Slave& slave, Nanoseconds largest) {
  const auto& outputs = slave.evidence.outputs.shift_too_short;
  Finding finding{code::kMissedByHeldFrames, Severity::kWarning, slave.position,
                  report.history.slaves[slave.position].shift_too_short.first(), outputs.time};
  finding.figures = {slave_figure(report, slave.position), times_figure("count", outputs.total, outputs.at_least),
                     time_figure("largest", largest)};
  finding.facts = sentence_of(*find_finding_words(code::kMissedByHeldFrames), "late");
  return finding;
}

void find_shift_too_short(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const auto& outputs = slave.evidence.outputs.shift_too_short;
  const auto& spells = report.history.slaves[slave.position].shift_too_short;
  const bool by_misses = (misses_told(findings, slave) || came_with_misses(report, findings, slave)) &&
                         !is_mostly_late(report, slave, findings);
  const bool told = by_misses || fell_unlocked(report, findings, slave) || sync0_had_moved(report, slave, spells);
  if (outputs.total > 0 && !told && !was_locked(report, slave, spells)) {
    findings.push_back(slid(report, slave));
  } else if (const auto held = outputs.total > 0 && !told ? held_up(report, slave, spells) : std::nullopt) {
    findings.push_back(came_held(report, slave, *held));
  } else if (outputs.total > 0 && !told) {
    const auto margin = slave.sync0_margin.value_or(0);
    const Nanoseconds need = slave.evidence.calc_and_copy_ns;
    const auto more = advised(need - margin + worst_lateness(report));
    findings.push_back({code::kShiftTooShort,
                        Severity::kWarning,
                        slave.position,
                        spells.first(),
                        outputs.time,
                        {slave_figure(report, slave.position), times_figure("count", outputs.total, outputs.at_least),
                         time_figure("margin", margin), time_figure("need", need), time_figure("more", more),
                         time_figure("shift", slave.sync0_shift + more)}});
  }
  const auto& inputs = slave.evidence.inputs.shift_too_short;
  if (inputs.total > 0) {
    findings.push_back({code::kInputShiftTooShort,
                        Severity::kWarning,
                        slave.position,
                        0,
                        inputs.time,
                        {slave_figure(report, slave.position), times_figure("count", inputs.total, inputs.at_least)}});
  }
}

/// Another finding says that frames come too late for this slave's SYNC0, and by how much.
bool is_told(const Findings& findings, const RunReport::Slave& slave) {
  return misses_told(findings, slave) || is_found(findings, slave, code::kShiftTooShort);
}

/// The usual lateness does not fit between frame and SYNC0: known before anything is missed, and true also where
/// something else made the slave miss more.
void find_too_tight(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const bool locked = was_locked(report);
  const auto lateness = usual_worst_lateness(report);
  constexpr std::uint64_t kEnough = 1000;
  if (!slave.sync0_margin || !locked || report.history.frame_lateness.count() < kEnough) return;
  if (is_told(findings, slave) || slave.evidence.sync0.misplaced()) return;
  // Also where the frames are in time, and nominally leave less than the slave needs for its outputs.
  const bool needs_more = nominally_too_short(slave);
  if (lateness <= *slave.sync0_margin && !needs_more) return;
  findings.push_back(
      {code::kSync0TooTight, Severity::kWarning, slave.position, 0, 0, {slave_figure(report, slave.position)}});
  std::ranges::copy(lateness_figures(report, slave), std::back_inserter(findings.back().figures));
  if (needs_more) findings.back().facts = sentence_of(*find_finding_words(code::kSync0TooTight), "need");
}

}  // namespace

void find_tight_sync0(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    find_shift_too_short(report, slave, findings);
    find_too_tight(report, slave, findings);
  }
}

}  // namespace syncline::diagnosis
