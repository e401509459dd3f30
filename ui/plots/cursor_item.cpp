// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/cursor_item.h"

#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace syncline::ui {

void CursorSet::set(Which which, std::optional<Nanoseconds> time) {
  if (cursors_[which] == time) return;
  cursors_[which] = time;
  keepPlace(which);
  Q_EMIT changed();
}

void CursorSet::keepPlace(Which which) {
  if (cursors_[which]) places_[which] = static_cast<double>(*cursors_[which] - begin_) / static_cast<double>(span_);
}

void CursorSet::setHeld(bool held) {
  if (held == std::exchange(held_, held)) return;
  for (const auto which : {kA, kB}) keepPlace(which);
  Q_EMIT changed();
}

void CursorSet::follow(Nanoseconds begin, Nanoseconds span) {
  begin_ = begin;
  span_ = std::max<Nanoseconds>(span, 1);
  if (!held_ || !any()) return;
  for (const auto which : {kA, kB}) {
    if (cursors_[which])
      cursors_[which] = begin_ + static_cast<Nanoseconds>(std::llround(places_[which] * static_cast<double>(span_)));
  }
  Q_EMIT changed();
}

void CursorSet::clear() {
  cursors_ = {};
  Q_EMIT changed();
}

void CursorSet::setPointer(std::optional<Nanoseconds> time) {
  if (pointer_ == time) return;
  pointer_ = time;
  Q_EMIT pointerMoved();
}

CursorItem::CursorItem(const CursorSet* cursors) : cursors_(cursors) { setZ(50); }

void CursorItem::setColors(const QColor& line, const QColor& text) {
  line_ = line;
  text_ = text;
}

void CursorItem::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap&, const QRectF& canvas) const {
  const auto place = [&](Nanoseconds time) {
    return x.p1() + grid_.column_of(time) * (x.p2() - x.p1()) / std::max(grid_.columns, 1);
  };
  const auto inside = [&](double at) { return at >= canvas.left() && at <= canvas.right(); };
  if (const auto pointer = cursors_->pointer(); pointer && inside(place(*pointer))) {
    painter->setPen(QPen(line_, 0, Qt::DotLine));
    painter->drawLine(QPointF(place(*pointer), canvas.top()), QPointF(place(*pointer), canvas.bottom()));
  }
  for (const auto which : {CursorSet::kA, CursorSet::kB}) {
    const auto time = cursors_->at(which);
    if (!time || !inside(place(*time))) continue;
    const double at = place(*time);
    painter->setPen(QPen(line_, 0));
    painter->drawLine(QPointF(at, canvas.top()), QPointF(at, canvas.bottom()));
    // A flag with the letter at the foot: the head belongs to the limit's label.
    const auto height = static_cast<double>(painter->fontMetrics().height());
    QRectF flag(at, canvas.bottom() - height, height, height);
    if (which == CursorSet::kB || flag.right() > canvas.right()) flag.moveRight(at);
    if (flag.left() < canvas.left()) flag.moveLeft(at);
    painter->fillRect(flag, line_);
    painter->setPen(text_);
    painter->drawText(flag, Qt::AlignCenter, which == CursorSet::kA ? QStringLiteral("A") : QStringLiteral("B"));
  }
}

}  // namespace syncline::ui
