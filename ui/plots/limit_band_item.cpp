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

void LimitBandItem::setColors(const QColor& fill, const QColor& line, const QColor& text_background) {
  fill_ = fill;
  line_ = line;
  background_ = text_background;
}

void LimitBandItem::drawLines(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas, double limit,
                              Qt::PenStyle style) const {
  painter.setPen(QPen(line_, 0, style));
  for (const double line : {y.transform(limit), y.transform(-limit)}) {
    if (line >= canvas.top() && line <= canvas.bottom())
      painter.drawLine(QPointF(canvas.left(), line), QPointF(canvas.right(), line));
  }
}

void LimitBandItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& y, const QRectF& canvas) const {
  if (limit_ <= 0) return;
  const double top = std::clamp(y.transform(limit_), canvas.top(), canvas.bottom());
  const double bottom = std::clamp(y.transform(-limit_), canvas.top(), canvas.bottom());
  painter->fillRect(QRectF(canvas.left(), top, canvas.width(), bottom - top), fill_);
  drawLines(*painter, y, canvas, limit_, Qt::DashLine);
  if (wanted_ > 0) drawLines(*painter, y, canvas, wanted_, Qt::DotLine);
}

void LimitBandItem::drawBox(QPainter& painter, const QRectF& box, const QString& text) const {
  auto background = background_;
  background.setAlpha(215);
  painter.fillRect(box, background);
  painter.setPen(line_);
  painter.drawText(box, Qt::AlignCenter, text);
}

void LimitBandItem::drawWords(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas) const {
  if (limit_ <= 0) return;
  const auto metrics = painter.fontMetrics();
  const auto boxOf = [&](const QString& text) {
    return QRectF(0, 0, metrics.horizontalAdvance(text) + 6, metrics.height());
  };
  const double top = y.transform(limit_);
  const bool outside = top < canvas.top();
  const auto text = outside ? label_ + QStringLiteral(" \u2191") : label_;
  auto box = boxOf(text);
  // Above its line where there is room: the data are below it.
  const bool above = !outside && top - box.height() - 2 >= canvas.top();
  box.moveTopLeft(QPointF(canvas.left() + 4, outside ? canvas.top() + 2 : above ? top - box.height() - 1 : top + 2));
  if (box.bottom() > canvas.bottom()) box.moveBottom(canvas.bottom() - 2);
  drawBox(painter, box, text);
  if (wanted_ <= 0) return;
  auto other = boxOf(wanted_label_);
  const double place =
      std::clamp(y.transform(wanted_) - other.height() - 1, canvas.top() + 2, canvas.bottom() - other.height());
  other.moveTopRight(QPointF(canvas.right() - 4, place));
  drawBox(painter, other, wanted_label_);
}

LimitWordsItem::LimitWordsItem(const LimitBandItem& band) : band_(band) {
  setZ(44);  // in front of the curves, behind marks and cursors
}

void LimitWordsItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& y, const QRectF& canvas) const {
  band_.drawWords(*painter, y, canvas);
}

}  // namespace syncline::ui
