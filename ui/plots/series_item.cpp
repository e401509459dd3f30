// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/series_item.h"

#include <qwt_clipper.h>
#include <qwt_painter.h>
#include <qwt_scale_map.h>

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "support/floor_to.h"

namespace syncline::ui {
namespace {

constexpr double kBreak = std::numeric_limits<double>::quiet_NaN();
/// From this many samples a column on, columns are drawn instead of the samples.
constexpr std::size_t kDense = 2;

/// Screen place of a column's left edge.
struct ColumnMap {
  double left, width;
  ColumnMap(const QwtScaleMap& x, int columns) : left(x.p1()), width((x.p2() - x.p1()) / std::max(columns, 1)) {}
  [[nodiscard]] double operator()(double column) const { return left + column * width; }
};

constexpr double kBeyondCanvas =
    4;  // pixels beyond the canvas that are drawn: the rasteriser would overflow far outside

/// Of bars and steps, which have no slope.
double clampedY(const QwtScaleMap& y, double value, const QRectF& canvas) {
  return std::clamp(y.transform(value), canvas.top() - kBeyondCanvas, canvas.bottom() + kBeyondCanvas);
}

std::optional<MinMaxSeries::Extent> extentOf(const std::vector<SeriesColumn>& columns) {
  std::optional<MinMaxSeries::Extent> extent;
  for (const auto& column : columns) {
    if (!column.valid) continue;
    if (!extent) extent = MinMaxSeries::Extent{column.min, column.max};
    extent = MinMaxSeries::Extent{std::min(extent->min, column.min), std::max(extent->max, column.max)};
  }
  return extent;
}

/// An SVG: a line without a width is next to nothing on paper, areas side by side show their seams.
bool isVector(const QPainter& painter) { return painter.paintEngine()->type() == QPaintEngine::SVG; }

}  // namespace

ColumnGrid ColumnGrid::of(Nanoseconds begin, Nanoseconds end, int columns) {
  ColumnGrid grid;
  grid.columns = std::max(columns, 1);
  grid.width = std::max<Nanoseconds>((end - begin + grid.columns / 2) / grid.columns, 1);
  // The newest sample lies in the last column.
  grid.origin = floor_to(end, grid.width) - (grid.columns - 1) * grid.width;
  return grid;
}

SeriesItem::SeriesItem(const QString& title) : QwtPlotItem(title) { setZ(20); }

void SeriesItem::setSeries(const MinMaxSeries* series) {
  held_ = nullptr;
  given_.clear();
  if (series_ == series) return;
  series_ = series;
  columns_.clear();
  points_.clear();
  extent_.reset();
}

void SeriesItem::setColumns(std::vector<SeriesColumn> columns, Nanoseconds width) {
  setSeries(nullptr);
  given_ = std::move(columns);
  given_width_ = width;
}

std::optional<MinMaxSeries::Reading> SeriesItem::valueAt(Nanoseconds time) const {
  if (series_ == nullptr) return std::nullopt;
  const auto own = time - shift_;
  auto reading = shape_ == Shape::kStep ? series_->held_at(own) : series_->at(own);
  if (reading && shape_ != Shape::kStep && own - reading->time > max_gap_) reading.reset();
  if (reading) reading->time += shift_;
  return reading;
}

void SeriesItem::prepare(const ColumnGrid& grid) {
  grid_ = grid;
  grid_.origin -= shift_;
  points_.clear();
  extent_.reset();
  if (series_ == nullptr) extent_ = extentOf(given_);
  if (series_ == nullptr || series_->empty()) return columns_.clear();
  if (held_ != nullptr) hold_until_ = held_->heard();
  const auto count = series_->count(grid_.origin, grid_.end());
  const bool dense = count > kDense * static_cast<std::size_t>(grid_.columns);
  if (dense && shape_ == Shape::kStep) {
    const auto hold_until = std::max(hold_until_, series_->last_time());
    extent_ = extentOf(columns_.steps_of(*series_, grid_.origin, grid_.end(), grid_.width, hold_until));
  } else if (dense) {
    extent_ = extentOf(columns_.of(*series_, grid_.origin, grid_.end(), grid_.width));
  } else {
    columns_.clear();
    extent_ = series_->extent(grid_.origin, grid_.end());
    preparePoints();
  }
}

void SeriesItem::preparePoints() {
  bool joined = false;
  Nanoseconds before = 0;
  const bool step = shape_ == Shape::kStep;
  const auto add = [&](Nanoseconds time, float value) {
    if (std::isnan(value)) {
      // What held until here ends here.
      if (step && joined) points_.emplace_back(grid_.column_of(time), points_.back().y());
      joined = false;
      return;
    }
    if (!points_.empty() && (!joined || (!step && time - before > max_gap_))) points_.emplace_back(0, kBreak);
    const double x = grid_.column_of(time);
    before = time;
    if (step && joined && points_.back().y() == static_cast<double>(value)) return;  // the step goes on
    if (step && !points_.empty() && !std::isnan(points_.back().y())) points_.emplace_back(x, points_.back().y());
    points_.emplace_back(x, value);
    joined = true;
  };
  // The line comes in from the left and leaves to the right.
  if (const auto left = step ? series_->held_at(grid_.origin - 1) : series_->at(grid_.origin - 1)) {
    if (step || grid_.origin - left->time < max_gap_) add(left->time, left->value);
    if (step && !extent_) extent_ = MinMaxSeries::Extent{left->value, left->value};
    if (step) extent_ = MinMaxSeries::Extent{std::min(extent_->min, left->value), std::max(extent_->max, left->value)};
  }
  series_->for_each(grid_.origin, grid_.end() + (step ? 0 : max_gap_), add);
  if (step && joined) {
    points_.emplace_back(grid_.column_of(std::min(std::max(hold_until_, before), grid_.end())), points_.back().y());
  }
}

void SeriesItem::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const {
  if (!columns().empty()) {
    drawColumns(painter, x, y, canvas);
  } else if (shape_ == Shape::kStep) {
    drawSteps(painter, x, y, canvas);
  } else if (!points_.empty()) {
    drawPoints(painter, x, y, canvas);
  }
}

void SeriesItem::drawColumns(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
                             const QRectF& canvas) const {
  const ColumnMap map(x, grid_.columns);
  const double ratio = painter->device()->devicePixelRatioF();
  // Those that were given are of the grid that was asked for, which may be another one by now: their edges lie between
  // those of pixels then, and no seam is to be seen there.
  const bool given = series_ == nullptr && given_width_ != grid_.width;
  const auto edge = [&](Nanoseconds time) { return std::round(map(grid_.column_of(time)) * ratio) / ratio; };
  const double line = std::max(1.0 / ratio, std::min(map.width, 1.0));
  // Bar by bar, each smoothed by itself, the seams would be seen.
  const bool is_vector = isVector(*painter);
  QPainterPath whole;
  whole.setFillRule(Qt::WindingFill);
  const SeriesColumn* previous = nullptr;
  for (std::size_t i = 0; i < columns().size(); ++i) {
    const auto& column = columns()[i];
    if (!column.valid) {
      // A column without a sample of a slower series is no gap as long as its neighbours are near.
      const bool step = shape_ == Shape::kStep;
      if (previous != nullptr && (step || column.start - previous->start > max_gap_)) previous = nullptr;
      continue;
    }
    float low = column.min;
    float high = column.max;
    if (previous != nullptr) {
      low = std::min(low, previous->max);
      high = std::max(high, previous->min);
    }
    const double top = clampedY(y, high, canvas);
    const double bottom = clampedY(y, low, canvas);
    // Moved by less than a column, it lies between two of the plot.
    const double left = given ? edge(column.start) : map(grid_.column_of(column.start));
    const double wide = given ? std::max(edge(column.start + given_width_) - left, line) : map.width;
    const QRectF bar(left, top, wide, std::max(bottom - top, line));
    if (is_vector) {
      whole.addRect(bar);
    } else {
      painter->fillRect(bar, color_);
    }
    previous = &column;
  }
  if (is_vector) painter->fillPath(whole, color_);
}

void SeriesItem::drawSteps(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const {
  constexpr double kThick = 2;
  const ColumnMap map(x, grid_.columns);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (std::isnan(points_[i - 1].y()) || std::isnan(points_[i].y())) continue;
    const double left = std::clamp(map(points_[i - 1].x()), canvas.left() - kThick, canvas.right() + kThick);
    const double right = std::clamp(map(points_[i].x()), canvas.left() - kThick, canvas.right() + kThick);
    const double first = clampedY(y, points_[i - 1].y(), canvas);
    const double second = clampedY(y, points_[i].y(), canvas);
    painter->fillRect(QRectF(left - kThick / 2, std::min(first, second) - kThick / 2, right - left + kThick,
                             std::abs(second - first) + kThick),
                      color_);
  }
}

void SeriesItem::drawPoints(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const {
  const ColumnMap map(x, grid_.columns);
  QPen pen(color_, 0);
  // Few points: the stroker may make the line as heavy as the filled columns are.
  const double ratio = painter->device()->devicePixelRatioF();
  if (ratio > 1 && points_.size() < 2000) pen.setWidthF(std::round(ratio));
  pen.setCosmetic(true);
  if (isVector(*painter)) pen = QPen(color_, 1);
  painter->setPen(pen);
  painter->setRenderHint(QPainter::Antialiasing, points_.size() < 2000);
  constexpr double kFarAway = 1e9;  // pixels; a logarithm of nothing is infinitely far
  const auto room = canvas.adjusted(-kBeyondCanvas, -kBeyondCanvas, kBeyondCanvas, kBeyondCanvas);
  QPolygonF line;
  line.reserve(static_cast<qsizetype>(points_.size()));
  const auto flush = [&] {
    if (line.size() == 1 && room.contains(line.front())) painter->drawPoint(line.front());
    // The line is cut where it leaves, and no point of it moved: it keeps its slope.
    if (line.size() > 1) QwtPainter::drawPolyline(painter, QwtClipper::clippedPolygonF(room, line));
    line.clear();
  };
  for (const auto& point : points_) {
    if (std::isnan(point.y())) {
      flush();
    } else {
      line.append(QPointF(map(point.x()), std::clamp(y.transform(point.y()), -kFarAway, kFarAway)));
    }
  }
  flush();
  painter->setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace syncline::ui
