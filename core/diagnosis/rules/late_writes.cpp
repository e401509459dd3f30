// SPDX-License-Identifier: Apache-2.0
// In the modes that write the reference clock's system time, a frame that is held up on its way brings it a time that
// is over by then: its control loop follows that (ESC data sheet I, 9.1.3), and all who follow it are off for a while.
#include <algorithm>
#include <optional>

#include "diagnosis/rules/rules.h"
#include "findings/run_codes.h"
#include "trace/run_report.h"

namespace syncline::diagnosis {
namespace {

/// Readings in turn show it so much later at most, and a controller whose error must last.
constexpr Nanoseconds kShownAfter = 100 * kMillisecond, kEndured = 400 * kMillisecond;

struct Effect {
  std::optional<Nanoseconds> first;
  Nanoseconds last = 0;
  std::int64_t deviation = 0;  // of slaves; 0: none was seen to leave
  void add(Nanoseconds from, Nanoseconds to, std::int64_t size) {
    first = std::min(first.value_or(from), from);
    last = std::max({last, from, to});
    deviation = std::max(deviation, std::abs(size));
  }
};

bool was_written_late(const RunReport& report, Nanoseconds loss, Nanoseconds shown_after) {
  const Spell before{loss - shown_after, loss, 0, 0};
  // What was under way when the adapter went is late, too, and by that.
  return steers_reference_clock(report.dcm.mode) && report.history.late_frames.near(before, kTogether) &&
         !adapter_was_away(report, before);
}

}  // namespace

bool was_written_late(const RunReport& report, Nanoseconds loss) { return was_written_late(report, loss, kShownAfter); }

bool was_written_late(const RunReport& report, const SyncLoss& loss, Left who) {
  // An ESC follows a single wrong time by a sixteenth and less, and slaves are a hundred and sixtieth behind it where
  // they hear of it each millisecond, and with longer cycles more: so much is explained, and no more.
  const auto slaves_share = 100 * kMillisecond / std::max(report.cycle_time, kMillisecond);
  const std::int64_t share = who == Left::kMaster ? 12 : std::max<Nanoseconds>(slaves_share, 12);
  if (!loss.back || !steers_reference_clock(report.dcm.mode)) return false;
  using enum dc::SyncObstacle;
  const bool endured = loss.obstacle == kErrorCode || loss.obstacle == kControlError;
  // All slaves at once (one alone is all of them), or the schedule's error; what else keeps somebody out of sync has
  // its own reason.
  const bool all = loss.obstacle == kClockStep || (who == Left::kSlaves && report.dc.followers == 1);
  const bool moved = all || loss.obstacle == kExternalClock || (who == Left::kMaster && endured);
  const bool explained = moved && loss.held > 0 && loss.held >= share * std::abs(loss.size);
  // A host that came too late itself, and found late what was under way, is another matter.
  const bool by_host = loss.obstacle == kCyclesLeftOut;
  return explained || (!by_host && was_written_late(report, loss.time, endured ? kEndured : kShownAfter));
}

void find_late_writes(const RunReport& report, Findings& findings) {
  Effect effect;
  for (const auto& loss : report.history.slave_losses) {
    if (was_written_late(report, loss, Left::kSlaves)) effect.add(loss.time, *loss.back, loss.size);
  }
  for (const auto& slave : report.slaves) {
    if (report.dc.monitored || slave.position == report.dc.reference_clock) continue;
    for (const auto& off : report.history.slaves[slave.position].off.list()) {
      if (was_written_late(report, off.from)) effect.add(off.from, off.to, off.largest);
    }
  }
  for (const auto& loss : report.history.master_losses) {
    if (was_written_late(report, loss, Left::kMaster)) effect.add(loss.time, *loss.back, 0);
  }
  if (!effect.first) return;
  Finding finding{code::kReferenceWrittenLate, Severity::kWarning, report.dc.reference_clock, *effect.first,
                  effect.last};
  finding.figures = {moment_figure(report, "since", *effect.first), time_figure("deviation", effect.deviation)};
  if (effect.deviation == 0) finding.facts = sentence_of(*find_finding_words(code::kReferenceWrittenLate), "master");
  findings.push_back(std::move(finding));
}

}  // namespace syncline::diagnosis
