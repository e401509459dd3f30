// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "sim/esc/esc.h"
#include "support/clock.h"

namespace syncline::sim {

/// One pass of a slave's firmware over its process data: takes next to no time, unless the firmware is slow. Outputs
/// that come meanwhile wait in their SyncManager.
class OwnLoop {
 public:
  explicit OwnLoop(Esc& esc) : esc_(esc) {}

  /// They have come to this SyncManager. Firmware that takes `takes` ns does not see them at once.
  void outputs_came(std::optional<unsigned> manager, Nanoseconds takes) {
    if (manager && (takes > 0 || end_)) esc_.leave_written(*manager);
  }
  /// Takes the outputs, unless the pass before is not over.
  [[nodiscard]] bool begin(std::optional<unsigned> manager, Nanoseconds time, Nanoseconds takes) {
    if (end_) return false;
    if (manager) esc_.take_written(*manager);
    if (takes > 0) end_ = time + takes;
    return true;
  }
  /// Whether one ended by `time` whose end was not asked for yet.
  [[nodiscard]] bool ended(Nanoseconds time) {
    if (!end_ || time < *end_) return false;
    end_.reset();
    return true;
  }
  [[nodiscard]] bool under_way() const { return end_.has_value(); }
  /// Nothing happens by itself before.
  [[nodiscard]] Nanoseconds end() const { return end_.value_or(INT64_MAX); }
  void stop() { end_.reset(); }

 private:
  Esc& esc_;
  std::optional<Nanoseconds> end_;
};

}  // namespace syncline::sim
