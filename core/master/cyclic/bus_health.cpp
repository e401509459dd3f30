// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/bus_health.h"

#include "channels/cycle_sample.h"
#include "channels/snapshot.h"
#include "master/exchange/event_teller.h"
#include "master/exchange/narrow.h"

#include <algorithm>
#include <utility>

namespace syncline {

void BusHealth::take(const MissingFrames::News& news, Nanoseconds time) {
  lost_.add(news.lost, 0, news.first_lost, 0);
  late_.add(news.late, news.late_by, time, news.late_after_lost);
  auto& snapshot = snapshot_;
  snapshot.late_frames += news.late;
  snapshot.lost_frames -= std::min<std::uint64_t>(snapshot.lost_frames, news.late);
}

void BusHealth::observe_frames(std::uint64_t missed, const MissingFrames::News& news, Nanoseconds time,
                               CycleSample& sample) {
  if (missed > 0) sample.flags |= CycleSample::kFrameLost;
  sample.frames_lost = to_16(missed);
  snapshot_.lost_frames += missed;
  if (news.late > 0) {
    sample.flags |= CycleSample::kFrameLate;
    sample.late_by_ns = static_cast<std::int32_t>(std::min<Nanoseconds>(news.late_by, INT32_MAX));
  }
  take(news, time);
}

void BusHealth::observe_schedule(std::int64_t skipped, Nanoseconds standstill, Nanoseconds time, CycleSample& sample) {
  if (skipped <= 0) return;
  sample.flags |= CycleSample::kOverrun;
  sample.skipped_cycles = to_16(static_cast<std::uint64_t>(skipped));
  ++snapshot_.overruns;
  snapshot_.skipped_cycles += static_cast<std::uint64_t>(skipped);
  skipped_.add(skipped, standstill, time);
}

void BusHealth::tell_left_out(const std::optional<Tally::Report>& report) {
  if (report) teller_.tell(report->time, -1, events::CyclesLeftOut{report->count, report->largest});
}

void BusHealth::tell_lost(const std::optional<Tally::Report>& report) {
  if (report) teller_.tell(report->time, -1, events::FramesLost{report->count});
}

void BusHealth::tell_late(const std::optional<Tally::Report>& report) {
  if (report) teller_.tell(report->time, -1, events::FramesLate{report->count, report->largest, report->special});
}

void BusHealth::tell(Nanoseconds now) {
  tell_left_out(skipped_.due(now));
  tell_lost(lost_.due(now));
  tell_late(late_.due(now));
}

void BusHealth::tell_rest(const MissingFrames::News& news) {
  take(news, snapshot_.time);
  tell_left_out(skipped_.rest());
  tell_lost(lost_.rest());
  tell_late(late_.rest());
}

}  // namespace syncline
