// SPDX-License-Identifier: Apache-2.0
#include "link/adapter_faults.h"

#include <algorithm>

#include "config/sim_config.h"

namespace syncline {
namespace {

const AdapterFaults::Span* span_at(const std::vector<AdapterFaults::Span>& spans, Nanoseconds time) {
  const auto found =
      std::ranges::find_if(spans, [time](const AdapterFaults::Span& s) { return time >= s.from && time < s.to; });
  return found == spans.end() ? nullptr : &*found;
}

Nanoseconds held(const std::vector<AdapterFaults::Span>& spans, Nanoseconds time) {
  const auto* span = span_at(spans, time);
  return span != nullptr ? span->longer : 0;
}

}  // namespace

AdapterFaults AdapterFaults::of(const SimConfig& config, Nanoseconds begin) {
  AdapterFaults faults;
  for (const auto& fault : config.faults) {
    const auto to = fault.until > fault.at ? begin + fault.until : INT64_MAX;
    const Span span{begin + fault.at, to, fault.value_ns};
    if (fault.kind == FaultKind::kHoldFrames) faults.holds_frames.push_back(span);
    if (fault.kind == FaultKind::kHoldAnswers) faults.holds_answers.push_back(span);
    if (fault.kind == FaultKind::kAdapterOff) faults.off.push_back(span);
  }
  return faults;
}

Nanoseconds AdapterFaults::frame_held(Nanoseconds time) const { return held(holds_frames, time); }
Nanoseconds AdapterFaults::answer_held(Nanoseconds time) const { return held(holds_answers, time); }
bool AdapterFaults::is_off(Nanoseconds time) const { return span_at(off, time) != nullptr; }

Nanoseconds AdapterFaults::next_off(Nanoseconds time, Nanoseconds latest) const {
  for (const auto& span : off) {
    if (span.from > time) latest = std::min(latest, span.from);
  }
  return latest;
}

}  // namespace syncline
