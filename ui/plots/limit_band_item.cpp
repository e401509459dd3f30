// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/limit_band_item.h"

#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>

namespace syncline::ui {

LimitBandItem::LimitBandItem() { setZ(12); }  // above the grid: a limit on a grid line stays visible

void LimitBandItem::setLimit(double limit, const QString& label) {
  limit_ = limit;
  label_ = label;
}

void LimitBandItem::setWanted(double limit, const QString& label) {
  wanted_ = limit;
  wanted_label_ = label;
}

void LimitBandItem::drawWanted(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas) const {
  if (wanted_ <= 0) return;
  painter.setPen(QPen(line_, 0, Qt::DotLine));
  for (const double line : {y.transform(wanted_), y.transform(-wanted_)}) {
    if (line >= canvas.top() && line <= canvas.bottom())
      painter.drawLine(QPointF(canvas.left(), line), QPointF(canvas.right(), line));
  }
  const auto metrics = painter.fontMetrics();
  QRectF box(0, 0, metrics.horizontalAdvance(wanted_label_) + 6, metrics.height());
  const double top =
      std::clamp(y.transform(wanted_) - box.height() - 1, canvas.top() + 2, canvas.bottom() - box.height());
  box.moveTopRight(QPointF(canvas.right() - 4, top));
  auto background = background_;
  background.setAlpha(215);
  painter.fillRect(box, background);
  painter.setPen(line_);
  painter.drawText(box, Qt::AlignCenter, wanted_label_);
}

void LimitBandItem::setColors(const QColor& fill, const QColor& line, const QColor& text_background) {
  fill_ = fill;
  line_ = line;
  background_ = text_background;
}

void LimitBandItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& y, const QRectF& canvas) const {
  if (limit_ <= 0) return;
  const double top = y.transform(limit_);
  const double bottom = y.transform(-limit_);
  const double shown_top = std::clamp(top, canvas.top(), canvas.bottom());
  const double shown_bottom = std::clamp(bottom, canvas.top(), canvas.bottom());
  painter->fillRect(QRectF(canvas.left(), shown_top, canvas.width(), shown_bottom - shown_top), fill_);
  QPen pen(line_, 0, Qt::DashLine);
  painter->setPen(pen);
  for (const double line : {top, bottom}) {
    if (line >= canvas.top() && line <= canvas.bottom()) {
      painter->drawLine(QPointF(canvas.left(), line), QPointF(canvas.right(), line));
    }
  }
  const bool outside = top < canvas.top();
  const auto text = outside ? label_ + QStringLiteral(" \u2191") : label_;
  const auto metrics = painter->fontMetrics();
  QRectF box(0, 0, metrics.horizontalAdvance(text) + 6, metrics.height());
  // Above its line where there is room: the data are below it.
  const bool above = !outside && top - box.height() - 2 >= canvas.top();
  box.moveTopLeft(QPointF(canvas.left() + 4, outside ? canvas.top() + 2 : above ? top - box.height() - 1 : top + 2));
  if (box.bottom() > canvas.bottom()) box.moveBottom(canvas.bottom() - 2);
  auto background = background_;
  background.setAlpha(215);
  painter->fillRect(box, background);
  painter->setPen(line_);
  painter->drawText(box, Qt::AlignCenter, text);
  drawWanted(*painter, y, canvas);
}

}  // namespace syncline::ui
