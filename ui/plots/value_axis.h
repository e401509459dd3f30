// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_axis_id.h>

#include <QFont>
#include <QPalette>
#include <QString>
#include <optional>

#include "config/monitor_view.h"
#include "ui/plots/slow_range.h"
#include "ui/plots/value_transform.h"

class QwtPlot;

namespace syncline::ui {

class UnitScaleDraw;

/// One of the two value axes of a plot: what it counts, on which scale, and which stretch of it is shown: by the data,
/// or as the user has fixed it.
class ValueAxis {
 public:
  enum class Quantity { kTime, kCount };
  struct Options {
    QString quantity;                 // without the unit
    Quantity kind = Quantity::kTime;  // times are nanoseconds, shown as ns, us, ms or s
    double minimum_span = 1;          // on a linear scale
    bool with_zero = false;
    QString unit{};    // of what is no time
    double least = 1;  // what is told apart from zero on a logarithmic scale
    bool operator==(const Options&) const = default;
  };

  ValueAxis(QwtPlot& plot, QwtAxisId axis, const Options& options);

  [[nodiscard]] QwtAxisId id() const { return axis_; }
  [[nodiscard]] const Options& options() const { return options_; }
  /// Another quantity begins with what is shown next.
  void setOptions(const Options& options);
  [[nodiscard]] ValueScale scale() const { return transform_.scale(); }
  /// Fixed limits stay.
  void setScale(ValueScale scale);

  /// Once a redraw with the smallest and the largest value that is visible; low > high: none is. `headroom`: so much of
  /// the height is kept free above them, 0..0.9.
  void update(double low, double high, double headroom);
  void fit();
  /// Nothing where low < high does not hold.
  void fix(const AxisLimits& limits);
  [[nodiscard]] bool isFixed() const { return fixed_.has_value(); }
  /// What is shown, in the axis's unit.
  [[nodiscard]] double low() const;
  [[nodiscard]] double high() const;
  /// Fixed from now on, `factor` times as much about `value`, which keeps its place.
  void zoom(double value, double factor);

  /// Onto the plot, in `height` logical pixels.
  void apply(const QPalette& palette, const QFont& font, int height);
  /// Without numbers, where there is nothing that they could be of.
  void setNumbers(bool on);

 private:
  void takeScale();
  void applyTicks(int height);

  QwtPlot& plot_;
  QwtAxisId axis_;
  Options options_;
  ValueTransform transform_;
  SlowRange range_;  // of places
  std::optional<AxisLimits> fixed_;
  bool numbers_ = true;
  UnitScaleDraw* draw_;  // the plot's
};

}  // namespace syncline::ui
