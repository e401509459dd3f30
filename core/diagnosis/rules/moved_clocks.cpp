// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/moved_clocks.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"

namespace syncline::diagnosis {
namespace {

/// In these SYNC0 was out of its place, or found back to it.
struct Away {
  Nanoseconds from = 0, to = 0;
  std::string_view why;
};

/// By how much SYNC0 may move, to the nearer side, until outputs come too late for one. Where the frames' own lateness
/// leaves no room at all, only what moves it further than that makes a difference.
Nanoseconds room_of(const RunReport& report, const RunReport::Slave& slave) {
  const auto margin = slave.sync0_margin.value_or(0);
  const Nanoseconds need = slave.evidence.calc_and_copy_ns;
  const auto lateness = usual_worst_lateness(report);
  const auto before = margin - need - lateness;
  if (before <= 0) return std::max<Nanoseconds>(0, lateness);
  return std::max<Nanoseconds>(0, std::min(before, slave.sync0_cycle - margin));
}

std::vector<Away> times_away(const RunReport& report, const RunReport::Slave& slave) {
  constexpr std::string_view kReference = "the reference clock has stepped";
  constexpr std::string_view kOwn = "its own clock was out of its place";
  std::vector<Away> result;
  if (slave.evidence.sync0.misplaced()) {
    result.push_back({report.history.begin, report.history.end, "its SYNC0 was started at another place"});
  }
  const auto room = room_of(report, slave);
  // A loss is told when the first reading shows it, and counters are read in turn behind it.
  const auto add = [&](Nanoseconds from, Nanoseconds to, std::int64_t size, std::string_view why) {
    if (std::abs(size) > room) result.push_back({from - kReadLater, to + kReadLater, why});
  };
  const auto until = [&](const RunHistory::SyncLoss& loss) { return loss.back.value_or(report.history.end); };
  for (const auto& loss : report.history.slave_losses) {
    if (loss.slave >= 0 && loss.slave != slave.position) continue;
    const bool reference = loss.obstacle == dc::SyncObstacle::kClockStep;
    // Where nobody was named, it was no further away than its own readings say.
    const auto own = std::abs(std::int64_t{slave.deviation_max_ns.value_or(0)});
    const bool somebody = !reference && loss.slave < 0;
    add(loss.time, until(loss), somebody ? std::min(std::abs(loss.size), own) : loss.size,
        reference ? kReference : kOwn);
  }
  for (const auto& loss : report.history.master_losses) {
    if (loss.obstacle == dc::SyncObstacle::kClockStep) add(loss.time, until(loss), loss.size, kReference);
  }
  // Where nobody monitors, its own readings tell.
  for (const auto& off : report.history.slaves[slave.position].off.list()) add(off.from, off.to, off.largest, kOwn);
  return result;
}

}  // namespace

std::optional<MovedSync0> sync0_had_moved(const RunReport& report, const RunReport::Slave& slave,
                                          const Spells& events) {
  const auto away = times_away(report, slave);
  std::optional<MovedSync0> moved;
  for (const auto& spell : events.list()) {
    const auto when =
        std::ranges::find_if(away, [&](const Away& time) { return spell.from <= time.to && time.from <= spell.to; });
    if (when == away.end()) continue;
    if (!moved) moved = MovedSync0{when->why, std::max(report.history.begin, when->from + kReadLater)};
    moved->counted += spell.count;
  }
  if (moved && 2 * moved->counted < events.count()) return std::nullopt;
  return moved;
}

std::optional<std::string_view> sync0_had_moved_at(const RunReport& report, const RunReport::Slave& slave,
                                                   Nanoseconds moment) {
  for (const auto& time : times_away(report, slave)) {
    if (moment >= time.from && moment <= time.to) return time.why;
  }
  return std::nullopt;
}

/// Read back when it was switched on.
void find_misplaced_sync0(const RunReport& report, Findings& findings) {
  for (const auto& slave : report.slaves) {
    const auto& start = slave.evidence.sync0;
    if (!slave.present || start.time == 0) continue;
    Finding finding{code::kSync0Never, Severity::kError, slave.position, start.time, report.history.end};
    finding.figures = {slave_figure(report, slave.position)};
    if (!start.never) {
      if (!start.misplaced()) continue;
      finding.code = code::kSync0Misplaced;
      finding.figures.push_back(time_figure("off", std::abs(Nanoseconds{start.off_ns})));
      finding.figures.push_back(time_figure("margin", slave.sync0_margin.value_or(0)));
      finding.figures.push_back(time_figure("need", slave.evidence.calc_and_copy_ns));
      if (start.off_ns < 0) finding.facts = sentence_of(*find_finding_words(code::kSync0Misplaced), "early");
    }
    findings.push_back(std::move(finding));
  }
}

}  // namespace syncline::diagnosis
