// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace syncline::ui {

/// Which few of many slaves a plot draws: the ones with the highest scores and one the user picked. A
/// drawn slave keeps its place and colour until another one is clearly worse, so that lines do not
/// change their meaning while one looks at them.
class SlaveSlots {
 public:
  explicit SlaveSlots(std::size_t count) : count_(count) {}

  struct Slot {
    int slave = -1;
    int color = 0;
    bool operator==(const Slot&) const = default;
  };
  /// `scores` by slave, negative = has no data. `picked` is always drawn, -1 = none. True when the
  /// choice changed.
  bool update(const std::vector<double>& scores, int picked);
  void clear() { slots_.clear(); }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Of so many from the next update() on; clear() before it where they become fewer.
  void setCount(std::size_t count) { count_ = count; }
  [[nodiscard]] const std::vector<Slot>& slots() const { return slots_; }

 private:
  [[nodiscard]] bool shows(int slave) const;
  [[nodiscard]] int freeColor(int slave) const;

  std::size_t count_;
  std::vector<Slot> slots_;
};

}  // namespace syncline::ui
