// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/rules/moved_clocks.h"

#include <algorithm>
#include <vector>

#include "diagnosis/rules/rules.h"

namespace syncline::diagnosis {
namespace {

/// In these a clock was out of its place, or found back to it.
struct Away {
  Nanoseconds from = 0, to = 0;
  std::string_view why;
};

std::vector<Away> times_away(const RunReport& report, int slave) {
  constexpr std::string_view kReference = "the reference clock has stepped";
  constexpr std::string_view kOwn = "its own clock was out of its place";
  std::vector<Away> result;
  const auto add = [&](const RunHistory::SyncLoss& loss, bool reference) {
    // A loss is told when the first reading shows it, and its counters are read in turn behind it.
    result.push_back(
        {loss.time - kReadLater, loss.back.value_or(report.history.end) + kReadLater, reference ? kReference : kOwn});
  };
  for (const auto& loss : report.history.slave_losses) {
    if (loss.slave < 0 || loss.slave == slave) add(loss, loss.obstacle == dc::SyncObstacle::kClockStep);
  }
  for (const auto& loss : report.history.master_losses) {
    if (loss.obstacle == dc::SyncObstacle::kClockStep) add(loss, true);
  }
  // Where nobody monitors, its own readings tell.
  for (const auto& off : report.history.slaves[static_cast<std::size_t>(slave)].off.list()) {
    result.push_back({off.from - kReadLater, off.to + kReadLater, kOwn});
  }
  return result;
}

}  // namespace

std::optional<MovedSync0> sync0_had_moved(const RunReport& report, int slave, const Spells& events) {
  const auto away = times_away(report, slave);
  std::optional<MovedSync0> moved;
  for (const auto& spell : events.list()) {
    const auto when =
        std::ranges::find_if(away, [&](const Away& time) { return spell.from <= time.to && time.from <= spell.to; });
    if (when == away.end()) continue;
    if (!moved) moved = MovedSync0{when->why, when->from + kReadLater};
    moved->counted += spell.count;
  }
  if (moved && 2 * moved->counted < events.count()) return std::nullopt;
  return moved;
}

}  // namespace syncline::diagnosis
