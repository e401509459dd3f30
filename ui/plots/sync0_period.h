// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRectF>
#include <optional>

#include "support/types.h"

class QPainter;
class QWidget;

namespace syncline::ui {

/// One SYNC0 period of a slave to scale, from left to right, as background of what is drawn over it: marks of time
/// below, a line and its name at both SYNC0, and in front of the second one the time that calculating and copying
/// takes.
class Sync0Period {
 public:
  static constexpr double kSide = 34, kTop = 20, kFoot = 20;  // px around the area, for its words

  /// `left`: px for what stands in front of it, kSide at least. `period`: > 0, or nothing may be drawn.
  Sync0Period(const QWidget& plot, Nanoseconds period, double left = kSide);
  /// Between the two SYNC0.
  [[nodiscard]] const QRectF& area() const { return area_; }
  /// Where a time since the first SYNC0 is drawn.
  [[nodiscard]] double xOf(double phase) const {
    return area_.left() + area_.width() * phase / static_cast<double>(period_);
  }

  /// Below what is drawn.
  void drawMarks(QPainter& painter) const;
  /// Over it; `calc_and_copy`: nothing where it is not known.
  void drawSync0(QPainter& painter, std::optional<Nanoseconds> calc_and_copy) const;

 private:
  void nameLine(QPainter& painter, double x) const;

  const QWidget& plot_;
  Nanoseconds period_;
  QRectF area_;
};

}  // namespace syncline::ui
