// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <QPointF>
#include <optional>
#include <vector>

#include "trace/held_series.h"
#include "trace/kept_columns.h"
#include "trace/min_max_series.h"
#include "ui/plots/signal_source.h"

namespace syncline::ui {

/// A stretch of time laid on picture columns. The columns' edges are multiples of their width since the
/// epoch, so a stretch that follows the data moves by whole columns and what is drawn does not shimmer.
struct ColumnGrid {
  Nanoseconds origin = 0;  // left edge of column 0
  Nanoseconds width = 1;   // of a column
  int columns = 0;
  bool operator==(const ColumnGrid&) const = default;

  [[nodiscard]] static ColumnGrid of(Nanoseconds begin, Nanoseconds end, int columns);
  [[nodiscard]] Nanoseconds end() const { return origin + width * columns; }
  [[nodiscard]] double column_of(Nanoseconds time) const {
    return static_cast<double>(time - origin) / static_cast<double>(width);
  }
};

/// Draws a MinMaxSeries. Where columns hold several samples, each column is filled from its minimum to
/// its maximum (a single outlier stays visible at any zoom, and the cost depends on the columns only);
/// where they hold few, the samples themselves are joined. Missing samples stay gaps.
///
/// Filled columns and cosmetic pens on purpose: a pen that the display's scale makes wider than one
/// device pixel sends Qt through its stroker, which is slower by orders of magnitude.
class SeriesItem final : public QwtPlotItem {
 public:
  enum class Shape { kLine, kStep, kEnvelope };

  explicit SeriesItem(const QString& title);

  /// The series must outlive the item or be replaced; null draws nothing.
  void setSeries(const MinMaxSeries* series);
  /// What is drawn instead while there is no series: columns of `width` ns, of what is not read yet.
  void setColumns(std::vector<SeriesColumn> columns, Nanoseconds width);
  void setShape(Shape shape) { shape_ = shape; }
  void setColor(const QColor& color) { color_ = color; }
  [[nodiscard]] const QColor& color() const { return color_; }
  [[nodiscard]] Shape shape() const { return shape_; }
  [[nodiscard]] const MinMaxSeries* series() const { return series_; }
  /// Neighbouring samples further apart than this are not joined (steps always are).
  void setMaxGap(Nanoseconds gap) { max_gap_ = gap; }
  /// Steps hold their last value as long as this has heard of it; null: until setHoldUntil().
  void setHeldBy(const HeldSeries* held) { held_ = held; }
  /// What it draws, where that is a signal of a run.
  void setSource(const SignalSource& source) { source_ = source; }
  [[nodiscard]] const std::optional<SignalSource>& source() const { return source_; }
  /// By how much its samples are drawn later than they were, ns; of another recording. Every time here is that of the
  /// plot.
  void setShift(Nanoseconds shift) { shift_ = shift; }
  [[nodiscard]] Nanoseconds shift() const { return shift_; }
  /// What is shown as the value at `time`: the reading before it, as long as it is not too old for that.
  [[nodiscard]] std::optional<MinMaxSeries::Reading> valueAt(Nanoseconds time) const;
  /// Steps hold their last value until here.
  void setHoldUntil(Nanoseconds time) { hold_until_ = time; }

  /// Reduces the stretch; once a redraw, before draw().
  void prepare(const ColumnGrid& grid);
  [[nodiscard]] std::optional<MinMaxSeries::Extent> extent() const { return extent_; }

  /// What the last prepare() left to draw: columns, or points by column (x) and value (y) with a
  /// not-a-number y between what must not be joined.
  [[nodiscard]] const std::vector<SeriesColumn>& columns() const {
    return series_ == nullptr ? given_ : columns_.columns();
  }
  [[nodiscard]] const std::vector<QPointF>& points() const { return points_; }

  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  void preparePoints();
  void drawColumns(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const;
  void drawSteps(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const;
  void drawPoints(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const;

  const MinMaxSeries* series_ = nullptr;
  const HeldSeries* held_ = nullptr;
  Shape shape_ = Shape::kLine;
  QColor color_ = Qt::black;
  Nanoseconds max_gap_ = 100 * kMillisecond;
  Nanoseconds hold_until_ = 0;
  Nanoseconds shift_ = 0;
  std::optional<SignalSource> source_;
  ColumnGrid grid_;  // in the time of the series
  KeptColumns columns_;
  std::vector<SeriesColumn> given_;
  Nanoseconds given_width_ = 0;
  std::vector<QPointF> points_;
  std::optional<MinMaxSeries::Extent> extent_;
};

}  // namespace syncline::ui
