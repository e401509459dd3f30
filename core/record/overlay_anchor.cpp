// SPDX-License-Identifier: Apache-2.0
#include "record/overlay_anchor.h"

#include <algorithm>

#include "record/run_record.h"
#include "trace/sync_overview.h"
#include "trace/trigger.h"

namespace syncline {
namespace {

/// The first is enough: it is looked for a portion at a time.
constexpr Nanoseconds kTriggerPortion = 60 * kSecond;

std::optional<Nanoseconds> first_episode(const RunRecord& run, Trigger trigger) {
  trigger.mode = Trigger::Mode::kSingle;
  trigger.hold_off = 0;
  TriggerWatch watch(trigger);
  for (const auto& event : run.events()) {
    if (watch.done()) break;
    watch.hear(event, run.samples());
  }
  watch.hear(run.findings(), run.samples());
  while (!watch.done() && !watch.look(run.samples(), kTriggerPortion)) {
  }
  if (watch.episodes().empty()) return std::nullopt;
  return watch.episodes().front().time;
}

}  // namespace

std::optional<Nanoseconds> overlay_anchor(const RunRecord& run, OverlayAlignment alignment, const Trigger& trigger) {
  if (run.samples().empty()) return std::nullopt;
  switch (alignment) {
    case OverlayAlignment::kBegin:
      return run.overview().begin;
    case OverlayAlignment::kArmed:
      return run.overview().armed;
    case OverlayAlignment::kTrigger:
      return first_episode(run, trigger);
  }
  return std::nullopt;
}

std::optional<Nanoseconds> overlay_offset(const RunRecord& first, const RunRecord& second, OverlayAlignment alignment,
                                          const Trigger& trigger) {
  const auto a = overlay_anchor(first, alignment, trigger);
  const auto b = overlay_anchor(second, alignment, trigger);
  if (!a || !b) return std::nullopt;
  return (*a - first.overview().begin) - (*b - second.overview().begin);
}

}  // namespace syncline
