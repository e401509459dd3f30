// SPDX-License-Identifier: Apache-2.0
#include "master/bus_health.h"

#include <utility>

namespace syncline {

void BusHealth::observe_wkc(std::uint16_t expected, std::uint16_t received, Nanoseconds time, CycleSample& sample) {
  sample.wkc_expected = expected;
  sample.wkc_received = received;
  // A lost frame is told as such, not a second time as a counter of zero.
  if (!judging_ || (sample.flags & CycleSample::kFrameLost) != 0) return;
  if (expected == received || (joining_ && received > expected)) {
    const auto count = std::exchange(wkc_spell_, 0);
    if (count > 1) {
      run_.event(EventKind::kWkcError, time, -1, last_expected_, last_wrong_, static_cast<std::int64_t>(count));
    }
    return;
  }
  sample.flags |= CycleSample::kWkcError;
  ++run_.snapshot.wkc_errors;
  last_wrong_ = received;
  last_expected_ = expected;
  if (wkc_spell_++ == 0) run_.event(EventKind::kWkcError, time, -1, expected, received, 1);
}

void BusHealth::observe_lost(std::uint64_t frames_lost, Nanoseconds time, CycleSample& sample) {
  if (frames_lost == 0) {
    const auto count = std::exchange(lost_spell_, 0);
    if (count > 1) run_.event(EventKind::kFramesLost, time, -1, static_cast<std::int64_t>(count));
    return;
  }
  sample.flags |= CycleSample::kFrameLost;
  run_.snapshot.lost_frames += frames_lost;
  if (lost_spell_ == 0) run_.event(EventKind::kFramesLost, time, -1, static_cast<std::int64_t>(frames_lost));
  lost_spell_ += frames_lost;
}

}  // namespace syncline
