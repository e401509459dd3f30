// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/band_item.h"

#include <qwt_scale_map.h>
#include <qwt_text.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plots/hatch.h"

namespace syncline::ui {
namespace {

constexpr double kBetweenLanes = 2;  // logical pixels between lanes
constexpr double kLabelRoom = 4;

/// With an outline instead of a plate: the states below it, the oldest that are shown, stay seen.
void drawOutlined(QPainter& painter, const QRectF& place, const QString& text, const QColor& color,
                  const QColor& outline) {
  painter.setPen(outline);
  for (const auto& [dx, dy] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1), std::pair(-1, -1),
                               std::pair(1, -1), std::pair(-1, 1), std::pair(1, 1)})
    painter.drawText(place.translated(dx, dy), Qt::AlignCenter, text);
  painter.setPen(color);
  painter.drawText(place, Qt::AlignCenter, text);
}

}  // namespace

BandItem::BandItem(const QString& title) : QwtPlotItem(title) { setZ(15); }

void BandItem::setSeries(const MinMaxSeries* series, const HeldSeries* held, States states) {
  series_ = series;
  held_ = held;
  states_ = std::move(states);
  stretches_.clear();
  known_.clear();
}

void BandItem::setLane(int lane, double height) {
  lane_ = lane;
  height_ = height;
}

const BandItem::State& BandItem::state(int value) const {
  const auto found = std::ranges::find(known_, value, &std::pair<int, State>::first);
  if (found != known_.end()) return found->second;
  return known_.emplace_back(value, states_(value)).second;
}

QString BandItem::stateAt(Nanoseconds time) const {
  if (series_ == nullptr || (held_ != nullptr && time > held_->heard())) return {};
  const auto reading = series_->held_at(time);
  return reading ? state(static_cast<int>(reading->value)).name : QString();
}

void BandItem::prepare(const ColumnGrid& grid) {
  grid_ = grid;
  stretches_.clear();
  if (series_ == nullptr || series_->empty()) return;
  const auto until = held_ != nullptr ? held_->heard() : series_->last_time();
  series_->step_columns(grid.origin, grid.end(), grid.width, until, columns_);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto& column = columns_[i];
    if (!column.valid) continue;
    const auto at = static_cast<int>(i);
    const bool changes = column.min != column.max;
    const Stretch one{at, at + 1, changes ? 0 : static_cast<int>(column.last), changes};
    // A single column in which one state follows another is the edge between them.
    auto* last = stretches_.empty() || stretches_.back().end != at ? nullptr : &stretches_.back();
    if (last != nullptr && last->value == one.value && last->changes == one.changes) {
      last->end = one.end;
    } else {
      stretches_.push_back(one);
    }
  }
}

void BandItem::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap&, const QRectF& canvas) const {
  const double width = (x.p2() - x.p1()) / std::max(grid_.columns, 1);
  const double top = canvas.top() + 1 + lane_ * height_;
  const double high = height_ - kBetweenLanes;
  const auto metrics = painter->fontMetrics();
  const QString title = this->title().text();
  const double label = title.isEmpty() ? 0 : metrics.horizontalAdvance(title) + 2 * kLabelRoom;
  for (const auto& stretch : stretches_) {
    const QRectF box(x.p1() + stretch.begin * width, top, (stretch.end - stretch.begin) * width, high);
    if (stretch.changes) {
      painter->fillRect(box, background_);
      fillHatched(*painter, box, label_);
      continue;
    }
    const auto& shown = state(stretch.value);
    painter->fillRect(box, shown.fill);
    // Right of the label, where there is one.
    QRectF words = box.adjusted(kLabelRoom, 0, -kLabelRoom, 0);
    words.setLeft(std::max(words.left(), canvas.left() + label + kLabelRoom));
    if (words.width() < metrics.horizontalAdvance(shown.name) || high < metrics.height() - 3) continue;
    painter->setPen(shown.text);
    painter->drawText(words, Qt::AlignLeft | Qt::AlignVCenter, shown.name);
  }
  if (title.isEmpty() || high < metrics.height() - 3) return;
  drawOutlined(*painter, QRectF(canvas.left(), top, label, high), title, label_, background_);
}

}  // namespace syncline::ui
