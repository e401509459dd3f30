// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::ui {

/// Range of a value axis that follows the data without nervousness: it grows at once, to round numbers,
/// and shrinks only after the data have needed much less for a while. Or it is fixed by the user.
class SlowRange {
 public:
  /// `minimum_span` in axis units; `with_zero`: zero is in the range unless the data are
  /// far from it.
  explicit SlowRange(double minimum_span = 1, bool with_zero = false, int hold_updates = 45);

  /// One call a redraw with the extent of what is visible; true when the range changed.
  bool update(double low, double high);
  /// The next update takes its extent at once.
  void fit();
  void fix(double low, double high);
  [[nodiscard]] bool isFixed() const { return fixed_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  /// Distance of the lines on the axis.
  [[nodiscard]] double step() const;

 private:
  void take(double low, double high);

  double minimum_span_;
  bool with_zero_;
  int hold_updates_;
  int roomy_updates_ = 0;
  bool fixed_ = false;
  bool fit_next_ = true;
  double low_ = 0, high_ = 1;
};

}  // namespace syncline::ui
