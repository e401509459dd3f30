// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "master/run_state.h"

namespace syncline {

/// Counts working counter errors and lost frames, and tells them as spells: one event when a spell
/// begins, one with the count when a longer one is over.
class BusHealth {
 public:
  explicit BusHealth(RunState& run) : run_(run) {}

  /// Working counters are judged in OP only: below it a slave may or may not take outputs.
  void set_judging(bool judging) { judging_ = judging; }
  [[nodiscard]] bool judging() const { return judging_; }
  /// While slaves join, their process data may count before anybody expects them.
  void set_joining(bool joining) { joining_ = joining; }
  void observe_wkc(std::uint16_t expected, std::uint16_t received, Nanoseconds time, CycleSample& sample);
  void observe_lost(std::uint64_t frames_lost, Nanoseconds time, CycleSample& sample);

 private:
  RunState& run_;
  bool judging_ = false, joining_ = false;
  std::uint64_t wkc_spell_ = 0, lost_spell_ = 0;
  std::uint16_t last_wrong_ = 0, last_expected_ = 0;
};

}  // namespace syncline
