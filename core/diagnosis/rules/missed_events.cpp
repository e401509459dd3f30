// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/missed_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "diagnosis/rules/moved_clocks.h"
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"

namespace syncline::diagnosis {
namespace {

/// All of them in the moments in which the host stood still.
bool missed_at_stalls(const RunReport& report, const RunReport::Slave& slave) {
  const auto& missed = report.history.slaves[slave.position].missed.list();
  return !missed.empty() && std::ranges::all_of(missed, [&](const Spell& spell) {
    return report.history.stalls.near({spell.from - kReadLater, spell.to, 0, 0}, kTogether);
  });
}

/// What the slave counted, and nobody saw when: frames that were held up left it less than it needs.
bool missed_at_holds(const RunReport& report, const RunReport::Slave& slave) {
  return held_up(report, slave, report.history.slaves[slave.position].missed).has_value();
}

/// Frames were lost each time, as many as it counts: which of them it had got, and which readings were an answer of
/// before, because the newer one was lost as well, nobody can tell one by one.
bool missed_at_losses(const RunReport& report, const RunReport::Slave& slave) {
  const auto& missed = report.history.slaves[slave.position].missed.list();
  const auto& lost = report.history.lost_frames;
  return !missed.empty() && lost.count() >= slave.sm2_missed->missed &&
         std::ranges::all_of(missed, [&](const Spell& spell) {
           return lost.near({spell.from - kReadLater, spell.to, 0, 0}, kTogether);
         });
}

std::string_view code_of(dc::MissCause cause, bool locked) {
  switch (cause) {
    case dc::MissCause::kFrameLost:
      return code::kMissedByLostFrames;
    case dc::MissCause::kCyclesLeftOut:
      return code::kMissedByHost;
    case dc::MissCause::kFrameHeldUp:
      return code::kMissedByHeldFrames;
    case dc::MissCause::kFrameLate:
      return locked ? code::kMissedByLateFrames : code::kMissedUnlocked;
    case dc::MissCause::kUnknown:
      break;
  }
  return locked ? code::kMissedUnexplained : code::kMissedUnlocked;
}

/// The schedule, whatever the host made of single frames.
bool breaks_lock(dc::SyncObstacle obstacle) {
  return obstacle == dc::SyncObstacle::kNoReferenceClock || obstacle == dc::SyncObstacle::kNoReading ||
         obstacle == dc::SyncObstacle::kErrorCode || obstacle == dc::SyncObstacle::kControlError;
}

/// Within this time, or so little before or behind it that counters read in turn do not tell.
bool was_unlocked_in(const RunReport& report, const Spell& spell, Nanoseconds finds_back = 0) {
  if (!is_controlled(report)) return true;
  const auto& losses = report.history.master_losses;
  // Never locked, or lost before anybody noted it.
  if (breaks_lock(report.dcm.obstacle) && (losses.empty() || losses.back().back)) return true;
  return std::ranges::any_of(losses, [&](const RunHistory::SyncLoss& loss) {
    const auto end = loss.back.value_or(report.history.end) + finds_back;
    return breaks_lock(loss.obstacle) && spell.to >= loss.time - kReadLater && spell.from <= end + kReadLater;
  });
}

bool was_mostly_locked(const RunReport& report, const Spells& events, Nanoseconds finds_back) {
  if (was_locked(report) || events.empty()) return was_locked(report);
  std::uint64_t unlocked = 0;
  for (const auto& spell : events.list()) unlocked += was_unlocked_in(report, spell, finds_back) ? spell.count : 0;
  return 2 * unlocked < events.count();
}

/// Nobody's outputs reach a slave that is cut off while its SYNC0 goes on: told as its absence, or as the adapter's.
bool was_cut_off(const RunReport& report, const RunReport::Slave& slave, std::uint64_t missed) {
  Nanoseconds away = 0;
  for (const auto* spells : {&report.history.slaves[slave.position].absences, &report.history.link_outages}) {
    for (const auto& spell : spells->list()) away += spell.to - spell.from + kReadLater;
  }
  return slave.sync0_cycle > 0 && missed <= static_cast<std::uint64_t>(away / slave.sync0_cycle);
}

/// A plug that is loose for a cycle or two lets frames turn back in front of the slave: the working counter is wrong
/// then, and a link was lost. Told as that.
bool was_passed_over(const RunReport& report, std::uint64_t missed) {
  std::uint64_t cycles = 0;
  for (const auto& spell : report.history.wrong_counters.list()) {
    if (lost_link_after(report, spell) >= 0) cycles += spell.count;
  }
  return missed <= cycles;
}

/// Its firmware stood still, and found when it went on what it had not seen meanwhile: told as that.
bool had_stood_still(const RunReport& report, const RunReport::Slave& slave) {
  const auto& history = report.history.slaves[slave.position];
  return !history.missed.empty() && std::ranges::all_of(history.missed.list(), [&](const Spell& spell) {
    return history.pdi_watchdog.near(spell, kReadLater) || history.pdi_silent.near(spell, kReadLater);
  });
}

/// All frames that were lost were so with somebody who went or came, in front of others who stayed: told as that.
bool lost_with_somebody(const RunReport& report) {
  constexpr Nanoseconds kNear = 500 * kMillisecond;  // he is missed when nothing has come for a while
  const auto& lost = report.history.lost_frames;
  return lost.count() > 0 && std::ranges::all_of(lost.list(), [&](const Spell& spell) {
           return spell.count == 0 || std::ranges::any_of(report.history.slaves, [&](const RunHistory::Slave& slave) {
                    return slave.absences.near(spell, kNear);
                  });
         });
}

/// Frames were lost, too, when the slave and the adapter were there: an outage does not excuse those.
bool lost_while_there(const RunReport& report, int slave) {
  const auto& absences = report.history.slaves[static_cast<std::size_t>(slave)].absences;
  return std::ranges::any_of(report.history.lost_frames.list(), [&](const Spell& spell) {
    return !adapter_was_away(report, spell) && !absences.near(spell, kReadLater);
  });
}

}  // namespace

bool is_controlled(const RunReport& report) {
  return report.dcm.mode != DcmMode::kOff && (!report.dcm.control_off || report.dcm.mode == DcmMode::kMasterShiftByApp);
}

bool was_locked(const RunReport& report) {
  return is_controlled(report) && !breaks_lock(report.dcm.obstacle) &&
         std::ranges::none_of(report.history.master_losses, breaks_lock, &RunHistory::SyncLoss::obstacle);
}

bool was_locked(const RunReport& report, const Spells& events) { return was_mostly_locked(report, events, 0); }

bool was_locked(const RunReport& report, const RunReport::Slave& slave, const Spells& events) {
  constexpr Nanoseconds kFindsBack = 30 * kSecond;  // 20 ms at 763 ppm
  return was_mostly_locked(report, events, slave.position < report.dc.reference_clock ? kFindsBack : 0);
}

bool was_locked(const RunReport& report, Nanoseconds moment) {
  return was_locked(report) || !was_unlocked_in(report, {moment, moment, 0, 0});
}

std::optional<Nanoseconds> held_up(const RunReport& report, const RunReport::Slave& slave, const Spells& times) {
  const auto& held = report.history.held_frames.list();
  const auto margin = slave.sync0_margin.value_or(0), need = Nanoseconds{slave.evidence.calc_and_copy_ns};
  const auto usual = usual_worst_lateness(report);
  if (times.empty() || margin - usual <= need) return std::nullopt;
  Nanoseconds largest = 0;
  const bool each = std::ranges::all_of(times.list(), [&](const Spell& spell) {
    return std::ranges::any_of(held, [&](const Spell& hold) {
      const bool then = hold.from <= spell.to && spell.from <= hold.to + kToldLater;
      // One that is held up may have left late, too; that is the lesser part of it.
      const auto late = std::max(usual, std::min(hold.largest, worst_lateness(report)));
      if (!then || margin - hold.largest - late >= need) return false;
      largest = std::max(largest, hold.largest);
      return true;
    });
  });
  return each ? std::optional(largest) : std::nullopt;
}

std::vector<Figure> lateness_figures(const RunReport& report, const RunReport::Slave& slave) {
  const auto lateness = usual_worst_lateness(report);
  const auto margin = slave.sync0_margin.value_or(0);
  const auto need = slave.evidence.calc_and_copy_ns;
  return {time_figure("margin", margin), time_figure("lateness", lateness), time_figure("need", need),
          time_figure("more", advised(worst_lateness(report) + need - margin))};
}

dc::MissCause main_cause(const Sm2MissedStatus& status) {
  const auto most = std::ranges::max_element(status.by_cause);
  return static_cast<dc::MissCause>(most - status.by_cause.begin());
}

dc::MissCause told_cause(const RunReport& report, const RunReport::Slave& slave, dc::MissCause cause) {
  const bool not_seen = cause == dc::MissCause::kUnknown;
  if (not_seen && missed_at_losses(report, slave)) return dc::MissCause::kFrameLost;
  if ((not_seen || cause == dc::MissCause::kFrameLate) && is_controlled(report) && missed_at_holds(report, slave))
    return dc::MissCause::kFrameHeldUp;
  if (cause != dc::MissCause::kFrameHeldUp) return cause;
  if (!is_controlled(report)) return dc::MissCause::kFrameLate;
  return missed_at_stalls(report, slave) ? dc::MissCause::kCyclesLeftOut : cause;
}

std::string_view miss_cause_words(const RunReport& report, const RunReport::Slave& slave, dc::MissCause cause) {
  const bool locked = was_locked(report, slave, report.history.slaves[slave.position].missed);
  switch (told_cause(report, slave, cause)) {
    case dc::MissCause::kFrameLost:
      return "frames were lost";
    case dc::MissCause::kCyclesLeftOut:
      return "the host left cycles out";
    case dc::MissCause::kFrameHeldUp:
      return "frames were held up on their way";
    case dc::MissCause::kFrameLate:
      if (locked) return "frames came behind the SYNC0 they were meant for";
      break;
    case dc::MissCause::kUnknown:
      if (locked) return "not seen by the master; look at its firmware and at frames that are damaged in front of it";
      break;
  }
  return "the master was not locked to the reference clock, and frames slid through its SYNC0";
}

void find_missed_outputs(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    if (!slave.sm2_missed || !slave.sm2_missed->known || slave.sm2_missed->missed == 0) continue;
    const auto told = [&](const Finding& f) {
      return (f.code == code::kSlaveFellByMisses || f.code == code::kSlaveFellByLateFrames) &&
             f.place.slave == slave.position;
    };
    if (std::ranges::any_of(findings, told)) continue;  // with all its figures
    if (slave.evidence.sync0.misplaced()) continue;     // told as that
    const auto& status = *slave.sm2_missed;
    const auto cause = main_cause(status);
    const bool by_absence = cause == dc::MissCause::kUnknown ||
                            (cause == dc::MissCause::kFrameLost && !lost_while_there(report, slave.position));
    if (by_absence && was_cut_off(report, slave, status.missed)) continue;
    if (cause == dc::MissCause::kFrameLost && lost_with_somebody(report)) continue;
    if (cause == dc::MissCause::kUnknown && was_passed_over(report, status.missed)) continue;
    if (cause == dc::MissCause::kUnknown && had_stood_still(report, slave)) continue;
    if (cause == dc::MissCause::kUnknown || cause == dc::MissCause::kFrameLate) {
      if (const auto moved = sync0_had_moved(report, slave, report.history.slaves[slave.position].missed)) {
        findings.push_back(
            {code::kMissedByMovedClock,
             Severity::kWarning,
             slave.position,
             moved->since,
             report.history.slaves[slave.position].missed.last(),
             {slave_figure(report, slave.position), count_figure("missed", status.missed, status.at_least),
              count_figure("part", std::min<std::uint64_t>(moved->counted, status.missed)),
              phrase_figure("why", moved->why), moment_figure(report, "since", moved->since)}});
        continue;
      }
    }
    const auto& spells = report.history.slaves[slave.position].missed;
    const auto why = told_cause(report, slave, cause);
    const auto of = [&](dc::MissCause each) { return status.by_cause[static_cast<std::size_t>(each)]; };
    Finding finding{
        code_of(why, was_locked(report, slave, spells)),
        Severity::kWarning,
        slave.position,
        spells.first(),
        spells.last(),
        {slave_figure(report, slave.position), count_figure("missed", status.missed, status.at_least),
         count_figure("part", of(cause) + (why == cause ? 0 : of(why))),
         count_figure("integrator", status.integrator_highest),
         status.limit > 0 ? count_figure("limit", status.limit) : phrase_figure("limit", "no limit"),
         count_figure("computed", status.computed), text_figure("sub", fmt::format("{:02X}", status.sub_index))}};
    std::ranges::copy(lateness_figures(report, slave), std::back_inserter(finding.figures));
    if (finding.code == code::kMissedUnlocked && !is_controlled(report))
      finding.facts = sentence_of(*find_finding_words(code::kMissedUnlocked), "off");
    findings.push_back(std::move(finding));
  }
}

}  // namespace syncline::diagnosis
