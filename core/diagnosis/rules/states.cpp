// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "config/slave_options.h"
#include "diagnosis/rules/missed_events.h"
#include "diagnosis/rules/moved_clocks.h"
#include "diagnosis/rules/rules.h"
#include "families/device_family.h"
#include "families/families.h"
#include "findings/run_codes.h"
#include "protocol/al_state.h"
#include "protocol/al_status_code.h"

namespace syncline::diagnosis {
namespace {

using Unit = Figure::Unit;

/// What a drive falls by is over so soon after it began.
constexpr Nanoseconds kJustBefore = 100 * kMillisecond;

std::string alarm_text(const RunReport& report, const RunReport::Slave& slave) {
  const auto& emergency = report.history.slaves[slave.position].emergency;
  if (!emergency || *emergency == 0) return {};
  return ", " + families::alarm_text(slave.identity, *emergency);
}

/// Nothing of what disturbs outputs was seen shortly before.
bool cycles_were_good(const RunReport& report, Nanoseconds fall) {
  const Spell before{fall - kJustBefore, fall, 0, 0};
  const auto& history = report.history;
  const bool damaged = std::ranges::any_of(history.slaves, [&](const RunHistory::Slave& slave) {
    return std::ranges::any_of(slave.port_errors, [&](const Spells& port) {
      return port.near({before.from, fall + kReadLater, 0, 0}, 0);
    });
  });
  return !damaged && !history.lost_frames.near(before, 0) && !history.late_frames.near(before, 0) &&
         !history.stalls.near(before, 0);
}

/// Who gives up by the rule of his family has reached his limit, whatever was computed meanwhile.
std::uint64_t integrator_at_fall(const RunReport& report, const RunReport::Slave& slave) {
  const auto computed = slave.sm2_missed->integrator_highest;
  const auto& emergency = report.history.slaves[slave.position].emergency;
  const auto* family = families::find(slave.identity);
  const bool by_limit = family != nullptr && family->error_limit && emergency == family->error_limit->error_code;
  return by_limit ? std::max(computed, slave.sm2_missed->limit) : computed;
}

/// It had been away shortly before: nobody's outputs came meanwhile, and that is told as its absence.
bool was_cut_off(const RunReport& report, const RunReport::Slave& slave, const RunHistory::Fall& fall) {
  const Spell before{fall.time - kReadLater, fall.time, 0, 0};
  if (adapter_was_away(report, before)) return true;
  return was_absent(report, slave.position, before);
}

/// When its firmware had stopped shortly before, which then finds SYNC0 gone on without it. That it stands still is
/// told when its PDI watchdog expires; while it goes on standing still its mailbox and what it leaves lying tell.
std::optional<Nanoseconds> had_stopped(const RunReport& report, const RunReport::Slave& slave,
                                       const RunHistory::Fall& fall) {
  constexpr Nanoseconds kBefore = 5 * kSecond;
  const auto& history = report.history.slaves[slave.position];
  const auto& stopped = history.pdi_watchdog.list();
  const auto after = std::ranges::find_if(stopped, [&](const Spell& spell) { return spell.from > fall.time; });
  if (after == stopped.begin()) return std::nullopt;
  const auto since = std::prev(after)->from;
  const Spell before{fall.time - kBefore, fall.time, 0, 0};
  const bool silent = history.silent_from > 0 && history.silent_to >= before.from && history.silent_from <= fall.time;
  const bool stood =
      since >= before.from || silent || history.late_outputs.near(before, 0) || history.late_inputs.near(before, 0);
  return stood ? std::optional(since) : std::nullopt;
}

std::uint64_t count_near(const Spells& spells, Nanoseconds from, Nanoseconds to) {
  std::uint64_t count = 0;
  for (const auto& spell : spells.list()) count += spell.from <= to && spell.to >= from ? spell.count : 0;
  return count;
}

/// Its error counter forgets a missed event within some cycles: what it missed long before, and got over or was led up
/// from again, is not why it fell. Of some events only its own counter knows.
bool missed_then(const RunReport& report, const RunReport::Slave& slave) {
  if (!slave.sm2_missed || !slave.sm2_missed->known || slave.sm2_missed->missed == 0) return false;
  const auto& history = report.history.slaves[slave.position];
  if (!history.fall || history.missed.empty()) return true;
  return count_near(history.missed, history.fall->time - kToldLater, history.fall->time + kToldLater) > 0;
}

/// Hours of single events that it got over are not why it fell: where the host stood still or frames were lost just
/// before, and that is about what it missed then, that is; otherwise what most of them have.
dc::MissCause cause_of_fall(const RunReport& report, const RunReport::Slave& slave) {
  const auto& status = *slave.sm2_missed;
  const auto most = main_cause(status);
  const auto& fall = report.history.slaves[slave.position].fall;
  if (!fall) return most;
  const auto begin = fall->time - kJustBefore;
  const auto missed = count_near(report.history.slaves[slave.position].missed, begin, fall->time + kReadLater);
  const auto is_one = [&](dc::MissCause cause, const Spells& spells) {
    const auto then = count_near(spells, begin, fall->time);
    return status.by_cause[static_cast<std::size_t>(cause)] > 0 && then > 0 && missed <= 2 * then + 2;
  };
  const bool lost = is_one(dc::MissCause::kFrameLost, report.history.lost_frames);
  const bool left_out = is_one(dc::MissCause::kCyclesLeftOut, report.history.stalls);
  if (lost && (most == dc::MissCause::kFrameLost || !left_out)) return dc::MissCause::kFrameLost;
  return left_out ? dc::MissCause::kCyclesLeftOut : most;
}

/// What was wrong within a moment before; empty where nothing is known. Goes behind "just before:".
std::string_view trouble_before(const RunReport& report, const RunReport::Slave& slave, const RunHistory::Fall& of) {
  constexpr std::uint16_t kOutputsWatchdog = 0x001B;
  const bool by_sync = is_about_outputs(of.al_status_code);
  if (!by_sync && of.al_status_code != kOutputsWatchdog) return {};
  const auto fall = of.time;
  const Spell before{fall - kJustBefore, fall, 0, 0};
  if (report.history.lost_frames.near(before, 0)) return "frames were lost";
  if (report.history.stalls.near(before, 0)) return "the host left cycles out";
  if (const auto moved = by_sync ? sync0_had_moved_at(report, slave, fall) : std::nullopt) return *moved;
  if (by_sync && !was_locked(report, fall))
    return "the master was not locked to the reference clock, and frames slid through its SYNC0";
  return {};
}

/// Where it counts nothing itself, what was seen elsewhere.
Finding with_trouble(const RunReport& report, const RunReport::Slave& slave, Finding finding) {
  const auto& fall = report.history.slaves[slave.position].fall;
  const auto why = fall ? trouble_before(report, slave, *fall) : "";
  if (why.empty()) return finding;
  finding.facts = sentence_of(*find_finding_words(code::kSlaveFell), "cause");
  std::ranges::find(finding.figures, "check", &Figure::name)->text = "what else is told of that moment";
  finding.figures.push_back(phrase_figure("why", why));
  return finding;
}

Finding fallen(const RunReport& report, const RunReport::Slave& slave) {
  const auto& fall = report.history.slaves[slave.position].fall;
  const auto since = fall ? fall->time : report.history.begin;
  const auto text = al_status_code_text(slave.al_status_code);
  Finding finding{code::kSlaveFell, Severity::kError, slave.position, since, report.history.end};
  finding.figures = {slave_figure(report, slave.position),
                     {"state", Unit::kAlStatus, slave.al_status},
                     {"alcode", Unit::kAlCode, slave.al_status_code},
                     text_figure("alarm", alarm_text(report, slave)),
                     moment_figure(report, "since", since),
                     phrase_figure("check", text.check)};
  if (!is_about_outputs(slave.al_status_code)) return with_trouble(report, slave, std::move(finding));
  const bool counted = slave.sm2_missed && slave.sm2_missed->known;
  const bool missed = missed_then(report, slave);
  const bool unseen = !missed || main_cause(*slave.sm2_missed) == dc::MissCause::kUnknown;
  if (const auto stopped = unseen && fall ? had_stopped(report, slave, *fall) : std::nullopt) {
    finding.code = code::kSlaveFellByHang;
    finding.figures.push_back(moment_figure(report, "stopped", *stopped));
    return finding;
  }
  if (!counted || !slave.sync0_margin) return with_trouble(report, slave, std::move(finding));
  if (unseen && fall && was_cut_off(report, slave, *fall)) {
    finding.facts = sentence_of(*find_finding_words(code::kSlaveFell), "cut");
    return finding;
  }
  if (!missed) {
    const bool misplaced = slave.evidence.sync0.misplaced();  // told as that
    if (const auto moved = fall && !misplaced ? sync0_had_moved_at(report, slave, fall->time) : std::nullopt) {
      finding.code = code::kSlaveFellByMovedClock;
      finding.figures.push_back(phrase_figure("why", *moved));
      return finding;
    }
    const bool in_time =
        usual_worst_lateness(report) < *slave.sync0_margin && slave.evidence.calc_and_copy_ns <= *slave.sync0_margin;
    const bool locked = fall ? was_locked(report, fall->time) : was_locked(report);
    const bool by_itself = fall && in_time && locked && !misplaced && cycles_were_good(report, fall->time);
    if (by_itself) finding.code = code::kSlaveFellByItself;
    if (!locked) finding.facts = sentence_of(*find_finding_words(code::kSlaveFell), "unlocked");
    finding.figures.push_back(time_figure("margin", *slave.sync0_margin));
    return finding;
  }
  finding.code = code::kSlaveFellByMisses;
  finding.figures.push_back(count_figure("missed", slave.sm2_missed->missed, slave.sm2_missed->at_least));
  finding.figures.push_back(count_figure("integrator", integrator_at_fall(report, slave)));
  finding.figures.push_back(count_figure("limit", slave.sm2_missed->limit));
  const auto cause = cause_of_fall(report, slave);
  const auto moved = cause == dc::MissCause::kUnknown || cause == dc::MissCause::kFrameLate
                         ? sync0_had_moved(report, slave, report.history.slaves[slave.position].missed)
                         : std::nullopt;
  finding.figures.push_back(phrase_figure("cause", moved ? moved->why : miss_cause_words(report, slave, cause)));
  finding.figures.push_back(count_figure("part", slave.sm2_missed->by_cause[static_cast<std::size_t>(cause)]));
  // More time before SYNC0 helps where there is a SYNC0 that frames can be late for.
  if (told_cause(report, slave, cause) == dc::MissCause::kFrameLate && !moved &&
      was_locked(report, slave, report.history.slaves[slave.position].missed))
    finding.code = code::kSlaveFellByLateFrames;
  std::ranges::copy(lateness_figures(report, slave), std::back_inserter(finding.figures));
  return finding;
}

/// Its error was acknowledged, and nobody could lead it further.
Finding refused(const RunReport& report, const RunReport::Slave& slave) {
  const auto& fall = *report.history.slaves[slave.position].fall;
  return {code::kSlaveRefused,
          Severity::kError,
          slave.position,
          fall.time,
          report.history.end,
          {slave_figure(report, slave.position),
           {"state", Unit::kAlStatus, slave.al_status},
           {"alcode", Unit::kAlCode, fall.al_status_code},
           moment_figure(report, "since", fall.time),
           phrase_figure("check", al_status_code_text(fall.al_status_code).check)}};
}

/// What became of it since does not make it undone.
void find_earlier_falls(const RunReport& report, const RunReport::Slave& slave, Findings& findings) {
  const auto& falls = report.history.slaves[slave.position].falls;
  const auto own = [&](const RunHistory::Fall& fall) { return !was_cut_off(report, slave, fall); };
  const auto first = std::ranges::find_if(falls, own);
  if (first == falls.end()) return;
  const auto count = static_cast<std::uint64_t>(std::count_if(first, falls.end(), own));
  Finding finding{code::kSlaveHadFallen, Severity::kWarning, slave.position, first->time, falls.back().time};
  finding.figures = {slave_figure(report, slave.position),
                     {"state", Unit::kAlStatus, first->al_status},
                     {"alcode", Unit::kAlCode, first->al_status_code},
                     text_figure("alarm", alarm_text(report, slave)),
                     moment_figure(report, "since", first->time),
                     times_figure("count", count, falls.size() == RunHistory::kMostFalls),
                     phrase_figure("check", al_status_code_text(first->al_status_code).check)};
  const auto why = trouble_before(report, slave, *first);
  if (!slave.present) {
    finding.facts = sentence_of(*find_finding_words(code::kSlaveHadFallen), "absent");
  } else if (!why.empty()) {
    finding.facts = sentence_of(*find_finding_words(code::kSlaveHadFallen), "cause");
    finding.figures.back() = phrase_figure("check", "what else is told of that moment");
    finding.figures.push_back(phrase_figure("why", why));
  }
  findings.push_back(std::move(finding));
}

}  // namespace

void find_states(const RunReport& report, Findings& findings) {
  AlState highest = AlState::kNone;
  for (const auto& slave : report.slaves) {
    if (slave.present) highest = std::max(highest, al_state_of(slave.al_status));
  }
  for (const auto& slave : report.slaves) {
    const bool known = slave.present && slave.al_status != 0;
    // Told as what it is in now, where it has not come out of it.
    if (!known || slave.al_status == static_cast<std::uint16_t>(AlState::kOp))
      find_earlier_falls(report, slave, findings);
    if (!known) continue;
    if (const auto& unasked = report.history.slaves[slave.position].unasked) {
      findings.push_back({code::kSlaveLeftUnasked,
                          Severity::kError,
                          slave.position,
                          unasked->time,
                          report.history.end,
                          {slave_figure(report, slave.position),
                           {"from", Unit::kAlStatus, static_cast<std::int64_t>(unasked->from)},
                           {"to", Unit::kAlStatus, static_cast<std::int64_t>(unasked->to)},
                           moment_figure(report, "since", unasked->time)}});
      if ((slave.al_status & kAlErrorFlag) == 0) continue;
    }
    if ((slave.al_status & kAlErrorFlag) != 0) {
      findings.push_back(fallen(report, slave));
    } else if (al_state_of(slave.al_status) < highest) {
      if (slave.evidence.sync0.never) continue;  // told as that
      if (report.history.slaves[slave.position].fall) {
        findings.push_back(refused(report, slave));
        continue;
      }
      findings.push_back({code::kSlaveBehind,
                          Severity::kWarning,
                          slave.position,
                          0,
                          0,
                          {slave_figure(report, slave.position), {"state", Unit::kAlStatus, slave.al_status}}});
    }
  }
}

}  // namespace syncline::diagnosis
