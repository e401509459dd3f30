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
  /// What the limits are, for LimitWordsItem.
  void drawWords(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas) const;

 private:
  void drawLines(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas, double limit, Qt::PenStyle style) const;
  void drawBox(QPainter& painter, const QRectF& box, const QString& text) const;

  double limit_ = 0, wanted_ = 0;
  QString label_, wanted_label_;
  QColor fill_, line_, background_;
};

/// The words of a band, in front of the curves: its area and its lines lie behind them. On the same axes.
class LimitWordsItem final : public QwtPlotItem {
 public:
  /// The band must outlive it.
  explicit LimitWordsItem(const LimitBandItem& band);
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  const LimitBandItem& band_;
};

}  // namespace syncline::ui
