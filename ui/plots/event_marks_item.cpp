// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/event_marks_item.h"

#include <qwt_scale_map.h>

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cstdlib>

namespace syncline::ui {
namespace {

constexpr double kHalfWidth = 4, kHeight = 7;
constexpr double kPole = 13;  // higher than the triangles, so that it is seen behind one

}  // namespace

void drawEventMark(QPainter& painter, const QPointF& foot, bool fault, const QColor& color) {
  const double base = fault ? foot.y() : foot.y() - kHeight;
  const double tip = fault ? foot.y() - kHeight : foot.y();
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF({{foot.x() - kHalfWidth, base}, {foot.x() + kHalfWidth, base}, {foot.x(), tip}}));
}

void drawNoteMark(QPainter& painter, const QPointF& foot, const QColor& color) {
  const QPointF top = foot - QPointF(0, kPole);
  painter.setPen(QPen(color, 1));
  painter.drawLine(foot, top);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF({top, top + QPointF(kHeight, kHalfWidth / 2 + 0.5), top + QPointF(0, kHalfWidth + 1)}));
}

EventMarksItem::EventMarksItem() { setZ(45); }

void EventMarksItem::setColors(const QColor& fault, const QColor& good, const QColor& note) {
  fault_ = fault;
  good_ = good;
  note_ = note;
}

std::span<const EventMark> EventMarksItem::within(Nanoseconds begin, Nanoseconds end) const {
  if (marks_ == nullptr) return {};
  const auto first = std::ranges::lower_bound(*marks_, begin, {}, &EventMark::time);
  return {first, std::ranges::lower_bound(first, marks_->end(), end, {}, &EventMark::time)};
}

std::optional<EventMark> EventMarksItem::nearest(Nanoseconds time, Nanoseconds reach) const {
  std::optional<EventMark> found;
  for (const auto& mark : within(time - reach, time + reach + 1)) {
    if (!found || std::llabs(mark.time - time) < std::llabs(found->time - time)) found = mark;
  }
  return found;
}

void EventMarksItem::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap&, const QRectF& canvas) const {
  painter->setPen(Qt::NoPen);
  painter->setRenderHint(QPainter::Antialiasing, true);
  const double width = (x.p2() - x.p1()) / std::max(grid_.columns, 1);
  const auto seen = within(grid_.origin, grid_.end());
  for (auto mark = seen.begin(); mark != seen.end();) {
    const auto column = static_cast<std::int64_t>(grid_.column_of(mark->time));
    const double at = x.p1() + grid_.column_of(mark->time) * width;
    bool fault = false, note = false, event = false;
    for (; mark != seen.end() && static_cast<std::int64_t>(grid_.column_of(mark->time)) == column; ++mark)
      (mark->note ? note : mark->fault ? fault : event) = true;
    if (note) drawNoteMark(*painter, {at, canvas.bottom()}, note_);
    if (fault || event) drawEventMark(*painter, {at, canvas.bottom()}, fault, color(fault));
  }
  painter->setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace syncline::ui
