// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/types.h"

namespace syncline {

struct CycleSample;
class EventTeller;
class SlaveStates;
struct Snapshot;

/// The working counter of the cyclic frames against what is expected of the slaves that are there. Errors are told as
/// spells: one event when a spell begins, one with the count when a longer one is over. What is expected follows from
/// the configuration (compile/cyclic_frames) and from who is absent (CyclicTaskRunner::expect_present).
class WorkingCounter {
 public:
  WorkingCounter(Snapshot& snapshot, const SlaveStates& states, EventTeller& teller)
      : snapshot_(snapshot), states_(states), teller_(teller) {}

  /// It is judged in OP only: below it a slave may or may not take outputs. A spell is over when judging ends.
  void set_judging(bool judging);
  /// Nothing is received that could be judged, for a while: a spell is over.
  void pause() { end_spell(last_time_); }
  [[nodiscard]] bool judging() const { return judging_; }
  /// While slaves join, their process data may count before anybody expects them.
  void set_joining(bool joining) { joining_ = joining; }
  /// In the cyclic thread, of each cycle.
  void observe(std::uint16_t expected, std::uint16_t received, Nanoseconds time, CycleSample& sample);

 private:
  void end_spell(Nanoseconds time);

  Snapshot& snapshot_;
  const SlaveStates& states_;
  EventTeller& teller_;
  bool judging_ = false, joining_ = false;
  std::uint64_t spell_ = 0;
  std::uint16_t last_wrong_ = 0, last_expected_ = 0;
  Nanoseconds last_time_ = 0;  // of the latest wrong one
};

}  // namespace syncline
