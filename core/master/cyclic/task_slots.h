// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline {

/// Numbers the bus cycles, those left out included. A task of n cycles goes with those whose number is a multiple of n.
/// Once the SYNC signals have a grid the numbers follow it: the outputs of such a task pass the reference clock just in
/// front of the SYNC0 that comes every n-th cycle, and not one of the cycles in between, which the slave would use as
/// much later; and they stay there when the host leaves cycles out.
class TaskSlots {
 public:
  explicit TaskSlots(Nanoseconds cycle_time) : cycle_time_(cycle_time) {}

  /// The next cycle, `left_out` having been left out in front of it. `since_base`: by how much the SYNC grid's base
  /// will have passed, ns, when what this cycle's frame carries is used nominally; nothing without a grid.
  std::int64_t next(std::int64_t left_out, std::optional<Nanoseconds> since_base);

 private:
  Nanoseconds cycle_time_;
  std::int64_t number_ = -1;
};

/// Whether the task is due in this cycle: the first time, at each multiple of `every`, and behind one that was left
/// out.
class TaskTurn {
 public:
  explicit TaskTurn(std::int64_t every) : every_(every) {}
  [[nodiscard]] bool take(std::int64_t slot);

 private:
  std::int64_t every_;
  std::optional<std::int64_t> turn_;
};

}  // namespace syncline
