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
  /// One cycle, lost frames included.
  void observe(Nanoseconds scheduled_time);
  /// The last second's mean period was more than 2 % off.
  [[nodiscard]] bool wrong() const { return wrong_; }

 private:
  Nanoseconds cycle_;
  std::optional<Nanoseconds> begin_;
  std::int64_t count_ = 0;
  bool wrong_ = false;
};

}  // namespace syncline::dc
