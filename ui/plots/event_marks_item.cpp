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

}  // namespace

EventMarksItem::EventMarksItem() { setZ(45); }

void EventMarksItem::setColors(const QColor& fault, const QColor& good) {
  fault_ = fault;
  good_ = good;
}

std::optional<EventMark> EventMarksItem::nearest(Nanoseconds time, Nanoseconds reach) const {
  if (marks_ == nullptr) return std::nullopt;
  std::optional<EventMark> found;
  for (auto mark = std::ranges::lower_bound(*marks_, time - reach, {}, &EventMark::time);
       mark != marks_->end() && mark->time <= time + reach; ++mark) {
    if (!found || std::llabs(mark->time - time) < std::llabs(found->time - time)) found = *mark;
  }
  return found;
}

void EventMarksItem::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap&, const QRectF& canvas) const {
  if (marks_ == nullptr) return;
  painter->setPen(Qt::NoPen);
  painter->setRenderHint(QPainter::Antialiasing, true);
  const double width = (x.p2() - x.p1()) / std::max(grid_.columns, 1);
  auto mark = std::ranges::lower_bound(*marks_, grid_.origin, {}, &EventMark::time);
  while (mark != marks_->end() && mark->time < grid_.end()) {
    const auto column = static_cast<std::int64_t>(grid_.column_of(mark->time));
    const double at = x.p1() + grid_.column_of(mark->time) * width;
    bool fault = false;
    for (; mark != marks_->end() && static_cast<std::int64_t>(grid_.column_of(mark->time)) == column; ++mark)
      fault = fault || mark->fault;
    const double foot = fault ? canvas.bottom() : canvas.bottom() - kHeight;
    const double tip = fault ? canvas.bottom() - kHeight : canvas.bottom();
    painter->setBrush(fault ? fault_ : good_);
    painter->drawPolygon(QPolygonF({{at - kHalfWidth, foot}, {at + kHalfWidth, foot}, {at, tip}}));
  }
  painter->setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace syncline::ui
