// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <vector>

#include "ui/plots/series_item.h"

namespace syncline::ui {

/// Hatches where nothing came back from the bus, so that an outage is seen as one and not as a plot without lines.
class GapItem final : public QwtPlotItem {
 public:
  GapItem();
  /// A signal that every cycle has whose frame came back; null: nothing is hatched. Neighbours further apart than
  /// `longest` have an outage between them.
  void setSeries(const MinMaxSeries* series, Nanoseconds longest);
  void setColor(const QColor& color) { color_ = color; }
  /// Once a redraw, before draw().
  void prepare(const ColumnGrid& grid);
  /// In columns of the grid.
  struct Stretch {
    int begin = 0, end = 0;
    bool operator==(const Stretch&) const = default;
  };
  [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  const MinMaxSeries* series_ = nullptr;
  Nanoseconds longest_ = 0;
  QColor color_ = Qt::gray;
  ColumnGrid grid_;
  std::vector<SeriesColumn> columns_;
  std::vector<Stretch> stretches_;
};

}  // namespace syncline::ui
