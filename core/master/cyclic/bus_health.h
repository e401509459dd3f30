// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "master/exchange/missing_frames.h"
#include "master/exchange/tally.h"
#include "support/types.h"

namespace syncline {

struct CycleSample;
class EventTeller;
struct Snapshot;

/// Counts frames that are lost or late, and cycles that were left out: tallied, so that the sum over the events is the
/// count. Working counters: working_counter.h.
class BusHealth {
 public:
  BusHealth(Snapshot& snapshot, EventTeller& teller) : snapshot_(snapshot), teller_(teller) {}

  /// `missed`: frames of this cycle that were not back at their deadline. They count as lost, until one is `news`
  /// as late.
  void observe_frames(std::uint64_t missed, const MissingFrames::News& news, Nanoseconds time, CycleSample& sample);
  /// `skipped`: cycles that were left out just before this one; `standstill`: since the frame before it.
  void observe_schedule(std::int64_t skipped, Nanoseconds standstill, Nanoseconds time, CycleSample& sample);
  /// Once a cycle: tells what is due.
  void tell(Nanoseconds now);
  /// At the end: tells what has not been told. `news`: all that is left.
  void tell_rest(const MissingFrames::News& news);

 private:
  Snapshot& snapshot_;
  EventTeller& teller_;
  void tell_left_out(const std::optional<Tally::Report>& report);
  void tell_lost(const std::optional<Tally::Report>& report);
  void tell_late(const std::optional<Tally::Report>& report);
  void take(const MissingFrames::News& news, Nanoseconds time);

  Tally lost_, late_, skipped_;
};

}  // namespace syncline
