// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <optional>

namespace syncline::ui {

/// The level of the trigger: a line across the plot with a "T" at its right end, so that it does not depend on colour.
class TriggerLevelItem final : public QwtPlotItem {
 public:
  TriggerLevelItem();
  /// In axis units; nothing hides the line.
  void setLevel(std::optional<double> level) { level_ = level; }
  [[nodiscard]] std::optional<double> level() const { return level_; }
  void setColors(const QColor& line, const QColor& text);
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  std::optional<double> level_;
  QColor line_, text_;
};

}  // namespace syncline::ui
