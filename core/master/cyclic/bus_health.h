// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "master/exchange/missing_frames.h"
#include "master/exchange/run_state.h"
#include "master/exchange/tally.h"

namespace syncline {

/// Counts working counter errors, frames that are lost or late, and cycles that were left out. Working counter errors
/// are told as spells: one event when a spell begins, one with the count when a longer one is over. The others are
/// tallied, so that the sum over the events is the count.
class BusHealth {
 public:
  explicit BusHealth(RunState& run) : run_(run) {}

  /// Working counters are judged in OP only: below it a slave may or may not take outputs.
  void set_judging(bool judging) { judging_ = judging; }
  [[nodiscard]] bool judging() const { return judging_; }
  /// While slaves join, their process data may count before anybody expects them.
  void set_joining(bool joining) { joining_ = joining; }
  void observe_wkc(std::uint16_t expected, std::uint16_t received, Nanoseconds time, CycleSample& sample);
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
  RunState& run_;
  bool judging_ = false, joining_ = false;
  void tell_left_out(const std::optional<Tally::Report>& report);
  void tell_lost(const std::optional<Tally::Report>& report);
  void tell_late(const std::optional<Tally::Report>& report);
  void take(const MissingFrames::News& news, Nanoseconds time);

  Tally lost_, late_, skipped_;
  std::uint64_t wkc_spell_ = 0;
  std::uint16_t last_wrong_ = 0, last_expected_ = 0;
};

}  // namespace syncline
