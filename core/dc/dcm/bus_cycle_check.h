// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline::dc {

/// Whether the cycles really come with the configured cycle time. A host that leaves cycles out, or a
/// timer set to another period, shows here before any controller can make sense of the phase.
class BusCycleCheck {
 public:
  explicit BusCycleCheck(Nanoseconds cycle_time) : cycle_(cycle_time) {}
  void start() { *this = BusCycleCheck(cycle_); }
  /// One cycle, lost frames included; `answered`: the reference clock's time came back.
  void observe(Nanoseconds scheduled_time, bool answered);
  /// The last second's mean period was more than 2 % off. The longest standstill of the host in it does not count: that
  /// is told as what it is, and comes once. A second with a silence of 50 ms in it does not count: an
  /// adapter that was away and is opened again keeps the host from its cycles, and that is not the timer's fault.
  [[nodiscard]] bool wrong() const { return wrong_; }

 private:
  void begin(Nanoseconds time);

  Nanoseconds cycle_;
  std::optional<Nanoseconds> begin_, last_;
  Nanoseconds standstill_ = 0;  // the longest, beyond a cycle
  std::int64_t count_ = 0;
  std::optional<Nanoseconds> silent_since_;
  bool wrong_ = false;
};

}  // namespace syncline::dc
