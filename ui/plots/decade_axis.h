// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline::ui {

/// A logarithmic axis: from the values that it has to show to places between 0 and 1.
class DecadeAxis {
 public:
  DecadeAxis() = default;
  /// `low` and `high` > 0; at least a decade, with a little room at both ends.
  DecadeAxis(double low, double high);

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  /// Of a value > 0; beyond 0..1 when it is outside.
  [[nodiscard]] double place(double value) const;
  [[nodiscard]] double value(double place) const;

  struct Tick {
    double value = 1;
    bool decade = false;
    bool labelled = false;
  };
  /// One to nine times each power of ten. Labelled are the decades, or every second or third of them where `most`
  /// labels have no room, and 2 and 5 times where there is room for them, too.
  [[nodiscard]] std::vector<Tick> ticks(int most) const;

 private:
  double low_ = 1, high_ = 10;
};

}  // namespace syncline::ui
