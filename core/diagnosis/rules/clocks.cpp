// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "channels/values/absent_after.h"
#include "channels/values/sync_obstacle_text.h"
#include "config/dcm_settings.h"
#include "dc/dcm/dcm_controller.h"
#include "diagnosis/rules/missed_events.h"
#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "protocol/dcm_error.h"

namespace syncline::diagnosis {
namespace {

using Unit = Figure::Unit;

Figure obstacle_figure(dc::SyncObstacle what) {
  return {"obstacle", Unit::kAside, 0, 0, std::string(dc::obstacle_text(what))};
}

/// Who moves a reference clock that this host leads; empty where it leads itself, or follows an external one (DCX), and
/// where it moved by `first` from one reading to the next, faster than its loop follows anybody. Behind an outage it
/// has its way back to the host's time, in long cycles for some seconds.
Figure led_figure(const RunReport& report, Nanoseconds moment, std::int64_t first = 0) {
  constexpr std::int64_t kFastest = 1'000, kCycles = 10;  // ppm, where an ESC's speed counter ends at 763; until seen
  constexpr Nanoseconds kWayBack = 10 * kSecond;
  const bool by_itself = std::abs(first) > report.dc.limit_ns + kCycles * report.cycle_time * kFastest / 1'000'000;
  const bool led = !by_itself && is_controlled(report) && steers_reference_clock(report.dcm.mode) &&
                   report.dcm.mode != DcmMode::kDcx;
  if (!led) return {"led", Unit::kAside, 0, 0, ""};
  const bool way_back = report.history.link_outages.near({moment - kWayBack, moment, 0, 0}, 0);
  return {"led", Unit::kAside, 0, 0,
          way_back ? "it was led back to this host's clock after the network adapter had been away"
                   : "it follows this host's clock, which a time service may have moved"};
}

/// It was away just before, or the adapter by which it hears the time, and finds its time again.
bool comes_back(const RunReport& report, const RunReport::Slave& slave, Nanoseconds moment) {
  const Spell then{moment, moment, 0, 0};
  return report.history.slaves[slave.position].absences.near(then, kSecond) || adapter_was_away(report, then);
}

/// Times in which a slave's own readings were over the limit, those left out that are told as something else.
Spell times_off(const RunReport& report, const RunReport::Slave& slave) {
  Spell off;
  for (const auto& spell : report.history.slaves[slave.position].off.list()) {
    if (was_written_late(report, spell.from) || comes_back(report, slave, spell.from)) continue;
    if (off.count == 0) off.from = spell.from;
    off.to = spell.to;
    off.count += spell.count;
    off.largest = std::max(off.largest, spell.largest);
  }
  return off;
}

/// Where those that were off were so at once and to the same side, or the master saw the reference clock step then: it
/// is not they who moved. Their readings are taken in turn. Nobody may have come or gone, which changes the way.
bool was_the_reference(const RunReport& report, const std::vector<std::pair<int, Spell>>& off) {
  if (off.empty()) return false;
  const auto& slaves = report.history.slaves;
  const auto turn = std::max(100 * kMillisecond, static_cast<Nanoseconds>(report.slaves.size()) * report.cycle_time);
  const auto first = std::ranges::min(off, {}, [](const auto& each) { return each.second.from; }).second.from;
  const Spell then{first - kSecond, first + turn, 0, 0};
  const auto moved = [&](const RunHistory::Slave& slave) { return slave.absences.near(then, 0); };
  if (std::ranges::any_of(slaves, moved)) return false;
  const bool ahead = slaves[static_cast<std::size_t>(off.front().first)].first_off_ns > 0;
  const bool alike = std::ranges::all_of(off, [&](const auto& each) {
    return each.second.from <= first + turn && (slaves[static_cast<std::size_t>(each.first)].first_off_ns > 0) == ahead;
  });
  const bool stepped = std::ranges::any_of(report.history.master_losses, [&](const RunHistory::SyncLoss& loss) {
    return loss.obstacle == dc::SyncObstacle::kClockStep && std::abs(loss.time - first) <= turn;
  });
  return alike && (stepped || off.size() >= 2);
}

void find_unmonitored(const RunReport& report, Findings& findings) {
  if (report.sync_window_enabled) {
    findings.push_back(
        {code::kNothingToMonitor, Severity::kNote, -1, 0, 0, {count_figure("clocks", report.dc.followers)}});
  } else {
    findings.push_back({code::kNotMonitored, Severity::kNote});
  }
  std::vector<std::pair<int, Spell>> all;
  for (const auto& slave : report.slaves) {
    if (slave.position == report.dc.reference_clock) continue;
    if (const auto off = times_off(report, slave); off.count > 0) all.emplace_back(slave.position, off);
  }
  const bool reference = was_the_reference(report, all);
  if (reference) {
    // One finding, of the clock that moved.
    auto& whole = all.front();
    for (const auto& [slave, off] : all) {
      whole.second.from = std::min(whole.second.from, off.from);
      whole.second.to = std::max(whole.second.to, off.to);
      whole.second.largest = std::max(whole.second.largest, off.largest);
    }
    whole.first = report.dc.reference_clock;
    all.resize(1);
  }
  for (const auto& [slave, off] : all) {
    findings.push_back({code::kSlaveClockOff,
                        Severity::kWarning,
                        slave,
                        off.from,
                        off.to,
                        {slave_figure(report, slave), time_figure("deviation", off.largest),
                         moment_figure(report, "since", off.from)}});
    if (!reference) continue;
    findings.back().figures.push_back(led_figure(report, off.from));
    findings.back().facts = sentence_of(*find_finding_words(code::kSlaveClockOff), "reference");
  }
}

/// Who left the sync window, and how far; nobody is named where it was not one alone.
void name_loss(const RunReport& report, const RunHistory::SyncLoss& loss, Finding& finding) {
  finding.figures = {slave_figure(report, loss.slave), time_figure("deviation", std::abs(loss.size)),
                     time_figure("limit", report.dc.limit_ns), moment_figure(report, "since", loss.time)};
  if (loss.slave < 0) finding.figures.front() = phrase_figure("slave", "one of the slaves");
}

/// They all moved at once and to the same side; or the only one that follows did, when the master saw the reference
/// clock step.
bool by_reference(const RunReport& report, const RunHistory::SyncLoss& loss) {
  constexpr Nanoseconds kSeen = 400 * kMillisecond;  // readings in turn, and the controller has patience
  if (loss.obstacle == dc::SyncObstacle::kClockStep) return true;
  return report.dc.followers == 1 && loss.slave >= 0 &&
         std::ranges::any_of(report.history.master_losses, [&](const RunHistory::SyncLoss& seen) {
           return seen.obstacle == dc::SyncObstacle::kClockStep && std::abs(seen.time - loss.time) <= kSeen;
         });
}

/// Nobody is the culprit: the loss from which the slaves have not come back names who it was.
Finding out_without_culprit(const RunReport& report) {
  const auto& dc = report.dc;
  const bool unknown = dc.state == SyncState::kUnknown;
  Finding finding{unknown ? code::kSlavesSyncUnknown : code::kSlavesOutOfSync, Severity::kError, -1, dc.since,
                  report.history.end};
  finding.figures = {time_figure("limit", dc.limit_ns), moment_figure(report, "since", dc.since)};
  const auto& losses = report.history.slave_losses;
  if (dc.state != SyncState::kOutOfSync || losses.empty() || losses.back().back) return finding;
  const auto& loss = losses.back();
  const bool stepped = by_reference(report, loss);
  if (!stepped && dc.over_limit > 0) return finding;
  name_loss(report, loss, finding);
  finding.place.slave = stepped ? dc.reference_clock : loss.slave;
  if (stepped) finding.figures.push_back(led_figure(report, loss.time, loss.size));
  const auto* variant = !stepped ? "left" : dc.over_limit > 0 ? "moving" : "stepped";
  finding.facts = sentence_of(*find_finding_words(code::kSlavesOutOfSync), variant);
  return finding;
}

/// The verdict's own culprit; nobody is named who is within the limit.
void find_out_of_sync(const RunReport& report, Findings& findings) {
  const auto& dc = report.dc;
  const auto* culprit = dc.culprit >= 0 && dc.culprit < static_cast<int>(report.slaves.size())
                            ? &report.slaves[static_cast<std::size_t>(dc.culprit)]
                            : nullptr;
  if (culprit == nullptr) {
    findings.push_back(out_without_culprit(report));
    return;
  }
  const auto deviation = std::abs(std::int64_t{culprit->deviation_ns.value_or(0)});
  findings.push_back({code::kSlaveLeftWindow,
                      Severity::kError,
                      dc.culprit,
                      dc.since,
                      report.history.end,
                      {slave_figure(report, dc.culprit), time_figure("deviation", deviation),
                       time_figure("limit", dc.limit_ns), moment_figure(report, "since", dc.since)}});
}

/// A slave that comes back finds its time again; that is told as its absence, also where the or-ed deviation of all
/// shows it before its own.
bool came_back(const RunReport& report, const RunHistory::SyncLoss& loss) {
  const auto was_away = [&](const RunHistory::Slave& slave) {
    return slave.absences.near({loss.time, loss.time, 0, 0}, kSecond);
  };
  const auto& slaves = report.history.slaves;
  return loss.slave < 0 ? std::ranges::any_of(slaves, was_away)
                        : was_away(slaves[static_cast<std::size_t>(loss.slave)]);
}

/// A reference clock that comes home, or a substitute, was compared with the others to some ten ns only: told as its
/// absence.
bool by_other_leader(const RunReport& report, const RunHistory::SyncLoss& loss) {
  constexpr std::int64_t kFewLimits = 2;
  const Spell before{loss.time - kTogether, loss.time, 0, 0};
  return loss.back && std::abs(loss.size) <= kFewLimits * report.dc.limit_ns &&
         report.history.lead_changes.near(before, kTogether);
}

/// Who leads was away: told as its absence, with all that there was to synchronise with.
bool leader_was_away(const RunReport& report, const RunHistory::SyncLoss& loss) {
  const auto leader = static_cast<std::size_t>(report.dc.reference_clock);  // of none: beyond all
  const auto& slaves = report.history.slaves;
  return loss.back && leader < slaves.size() && slaves[leader].absences.near({loss.time, loss.time, 0, 0}, kSecond);
}

/// Without the adapter nobody hears the time; who found it again afterwards has nothing wrong with him.
bool without_adapter(const RunReport& report, const RunHistory::SyncLoss& loss) {
  return loss.back && adapter_was_away(report, {loss.time, loss.time, 0, 0});
}

/// While the host stands still, or all frames get lost, nobody tells the slaves the time, and their quartzes run apart;
/// nor the reference clock that the host leads, which takes all with it when it is put right: no more than that, and
/// told as what the host did, or with the frames.
bool without_time(const RunReport& report, const RunHistory::SyncLoss& loss) {
  constexpr std::int64_t kApart = 10'000;  // standing still for so much longer than the deviation: 100 ppm
  const bool led = is_controlled(report) && steers_reference_clock(report.dcm.mode);
  if (!loss.back || (loss.obstacle == dc::SyncObstacle::kClockStep && !led)) return false;
  const auto explains = [&](const Spell& spell, Nanoseconds length) {
    const bool then = loss.time + kTogether >= spell.from && loss.time <= spell.to + kTogether;
    return then && std::abs(loss.size) * kApart <= length;
  };
  const auto& history = report.history;
  return std::ranges::any_of(history.stalls.list(), [&](const Spell& s) { return explains(s, s.largest); }) ||
         std::ranges::any_of(history.lost_frames.list(), [&](const Spell& s) { return explains(s, s.to - s.from); });
}

/// Too short for anybody to be missed, long enough for those behind it to be told the time by another way.
bool by_lost_link(const RunReport& report, const RunHistory::SyncLoss& loss) {
  constexpr std::int64_t kLongestWay = 10 * kMicrosecond;
  return loss.back && loss.obstacle != dc::SyncObstacle::kClockStep && std::abs(loss.size) <= kLongestWay &&
         lost_link_after(report, {loss.time, loss.time, 0, 0}) >= 0;
}

/// While no frame comes back, or none in time, nobody hears the time either: told with the frames.
bool without_frames(const RunReport& report, const RunHistory::SyncLoss& loss) {
  if (!loss.back || (loss.obstacle != dc::SyncObstacle::kNoReading && loss.obstacle != dc::SyncObstacle::kSettling))
    return false;
  const Spell silence{loss.time - kAbsentAfter, loss.time, 0, 0};
  return report.history.lost_frames.near(silence, kTogether) || report.history.late_frames.near(silence, kTogether);
}

/// Of those who are not in sync at the end what came before is told as well, by others than `culprit`.
void find_left_window(const RunReport& report, std::optional<int> culprit, Findings& findings) {
  const auto& all = report.history.slave_losses;
  std::vector<RunHistory::SyncLoss> losses;
  std::ranges::copy_if(all, std::back_inserter(losses), [&](const RunHistory::SyncLoss& loss) {
    const bool lasts = culprit && !loss.back && &loss == &all.back();
    const bool told =
        lasts || (loss.slave >= 0 && loss.slave == culprit) || was_written_late(report, loss, Left::kSlaves);
    return !told && !came_back(report, loss) && !without_adapter(report, loss) && !without_time(report, loss) &&
           !by_lost_link(report, loss) && !by_other_leader(report, loss);
  });
  if (losses.empty()) return;
  const auto& first = losses.front();
  Finding finding{code::kWindowLeft, Severity::kWarning, first.slave, first.time, losses.back().back.value_or(0)};
  name_loss(report, first, finding);
  finding.figures.push_back(times_figure("count", losses.size()));
  const bool stepped = by_reference(report, first);
  if (stepped) {
    finding.place.slave = report.dc.reference_clock;
    finding.figures.push_back(led_figure(report, first.time, first.size));
  }
  const auto* of_all = culprit ? "stepped before" : "stepped";
  const auto* variant = stepped ? of_all : culprit ? "before" : "";
  finding.facts = sentence_of(*find_finding_words(code::kWindowLeft), variant);
  findings.push_back(std::move(finding));
}

/// What no reading shows: who follows with the delay of a way that is not there any more.
void find_changed_ways(const RunReport& report, Findings& findings) {
  for (std::size_t i = 0; i < report.slaves.size(); ++i) {
    const RunHistory::WayChange *first = nullptr, *last = nullptr;
    std::int64_t largest = 0;
    for (const auto& change : report.history.way_changes) {
      if (change.slave != static_cast<int>(i)) continue;
      if (first == nullptr) first = &change;
      last = &change;
      largest = std::max(largest, change.deviation);
    }
    if (first == nullptr) continue;
    const bool back = report.slaves[i].present;
    const auto end = last->renewed ? *last->renewed
                     : back        ? report.history.slaves[i].absences.last()
                                   : report.history.end;
    Finding finding{code::kFramesWayChanged, Severity::kWarning, static_cast<int>(i), first->time, end};
    finding.figures = {slave_figure(report, static_cast<int>(i)), moment_figure(report, "since", first->time),
                       time_figure("deviation", largest)};
    if (last->renewed) finding.figures.push_back(moment_figure(report, "renewed", *last->renewed));
    const auto* variant = last->renewed ? "renewed" : back ? "back" : "";
    finding.facts = sentence_of(*find_finding_words(code::kFramesWayChanged), variant);
    findings.push_back(std::move(finding));
  }
}

void find_external_not_met(const RunReport& report, Findings& findings) {
  const auto away = std::abs(Nanoseconds{report.dcm.external_error_ns.value_or(0)});
  const auto left = static_cast<double>(away) / dc::kDcxFastestPpm * 1e6;
  findings.push_back({code::kExternalClockNotMet,
                      Severity::kError,
                      -1,
                      0,
                      0,
                      {time_figure("external", away), time_figure("left", std::llround(left))}});
}

/// The way to it at the beginning, or when the bridge is back, is none that it left.
void find_external_left(const RunReport& report, Findings& findings) {
  std::size_t count = 0;
  Nanoseconds since = 0, back = 0, largest = 0;
  for (const auto& loss : report.history.master_losses) {
    if (loss.obstacle != dc::SyncObstacle::kExternalClock || was_written_late(report, loss, Left::kMaster)) continue;
    if (count++ == 0) since = loss.time;
    back = loss.back.value_or(report.history.end);
    largest = std::max(largest, std::abs(Nanoseconds{loss.size}));
  }
  if (count == 0) return;
  findings.push_back(
      {code::kExternalClockLeft,
       Severity::kWarning,
       -1,
       since,
       back,
       {times_figure("count", count), moment_figure(report, "since", since), time_figure("external", largest)}});
}

}  // namespace

void find_clocks(const RunReport& report, Findings& findings) {
  if (!report.dc.enabled || has_other_master(report)) return;
  find_changed_ways(report, findings);
  // Also where nobody follows who leads by now.
  if (!report.dc.monitored || report.dc.state == SyncState::kNotMonitored) return find_unmonitored(report, findings);
  if (report.dc.state == SyncState::kInSync) return find_left_window(report, std::nullopt, findings);
  find_out_of_sync(report, findings);
  find_left_window(report, findings.back().place.slave, findings);
}

void find_master_sync(const RunReport& report, Findings& findings) {
  const auto& dcm = report.dcm;
  if (!report.dc.enabled || dcm.mode == DcmMode::kOff || has_other_master(report)) return;
  std::vector<RunHistory::SyncLoss> losses;
  std::ranges::copy_if(report.history.master_losses, std::back_inserter(losses), [&](const RunHistory::SyncLoss& loss) {
    const bool told = was_written_late(report, loss, Left::kMaster);
    // Where nobody controls, the schedule leaves its place as a matter of course; what steps is told all the same.
    const bool wanders = !is_controlled(report) && (!loss.back || loss.obstacle == dc::SyncObstacle::kControlError);
    return !told && !wanders && !dc::is_of_external_clock(loss.obstacle) && !leader_was_away(report, loss) &&
           !without_adapter(report, loss) && !without_frames(report, loss);
  });
  const auto drift = Figure{"drift", Unit::kPpm, std::llround(dcm.drift_ppm * 1000)};
  if (std::abs(dcm.drift_ppm) > dc::kMostDriftPpm) {
    findings.push_back({code::kDriftTooHigh, Severity::kError, -1, 0, 0, {drift}});
  } else if (dcm.error_code != 0) {
    findings.push_back({code::kDcmError,
                        Severity::kError,
                        -1,
                        0,
                        0,
                        {{"code", Unit::kHex32, dcm.error_code},
                         phrase_figure("meaning", dc::dcm_error_text(dcm.error_code)),
                         drift}});
  } else if (dcm.state != SyncState::kInSync && !dcm.control_off && dc::is_of_external_clock(dcm.obstacle)) {
    find_external_not_met(report, findings);
  } else if (dcm.state != SyncState::kInSync && !dcm.control_off) {
    // Not since the loss that it has not come back from: never.
    const bool was = !losses.empty() && !losses.back().back;
    findings.push_back({code::kMasterNotLocked,
                        Severity::kError,
                        -1,
                        was ? losses.back().time : report.history.begin,
                        report.history.end,
                        {time_figure("error", dcm.error_ns), obstacle_figure(dcm.obstacle), drift}});
  } else if (!losses.empty()) {
    findings.push_back({code::kMasterLostLock,
                        Severity::kWarning,
                        -1,
                        losses.front().time,
                        losses.back().back.value_or(0),
                        {times_figure("count", losses.size()), moment_figure(report, "since", losses.front().time),
                         obstacle_figure(losses.front().obstacle)}});
  }
  if (dcm.state == SyncState::kInSync) find_external_left(report, findings);
}

}  // namespace syncline::diagnosis
