// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <QString>

namespace syncline::ui {

/// Permitted range about zero: shaded, with a line at each limit and the limit in words, so that it does
/// not depend on colour. A limit that lies outside the axis is named at the canvas edge.
class LimitBandItem final : public QwtPlotItem {
 public:
  LimitBandItem();
  /// 0 hides the band. In axis units.
  void setLimit(double limit, const QString& label);
  [[nodiscard]] double limit() const { return limit_; }
  /// A limit that is wanted, but not the one that holds: dotted lines; 0: none.
  void setWanted(double limit, const QString& label);
  [[nodiscard]] double wanted() const { return wanted_; }
  void setColors(const QColor& fill, const QColor& line, const QColor& text_background);
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  void drawWanted(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas) const;

  double limit_ = 0, wanted_ = 0;
  QString label_, wanted_label_;
  QColor fill_, line_, background_;
};

}  // namespace syncline::ui
