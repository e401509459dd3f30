// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/trigger_level_item.h"

#include <qwt_scale_map.h>

#include <QPainter>

namespace syncline::ui {

TriggerLevelItem::TriggerLevelItem() { setZ(45); }  // above the data, below the cursors

void TriggerLevelItem::setColors(const QColor& line, const QColor& text) {
  line_ = line;
  text_ = text;
}

void TriggerLevelItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& y, const QRectF& canvas) const {
  if (!level_) return;
  const double at = y.transform(*level_);
  if (at < canvas.top() || at > canvas.bottom()) return;
  painter->setPen(QPen(line_, 0, Qt::DashDotLine));
  painter->drawLine(QPointF(canvas.left(), at), QPointF(canvas.right(), at));
  const auto side = static_cast<double>(painter->fontMetrics().height());
  QRectF flag(canvas.right() - side, at - side / 2, side, side);
  if (flag.top() < canvas.top()) flag.moveTop(canvas.top());
  if (flag.bottom() > canvas.bottom()) flag.moveBottom(canvas.bottom());
  painter->fillRect(flag, line_);
  painter->setPen(text_);
  painter->drawText(flag, Qt::AlignCenter, QStringLiteral("T"));
}

}  // namespace syncline::ui
