// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/hatch.h"

#include <QLineF>
#include <QList>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace syncline::ui {

void fillHatched(QPainter& painter, const QRectF& area, const QColor& color) {
  constexpr double kApart = 8;
  QList<QLineF> lines;
  // On a line x + y is the same everywhere.
  for (double sum = std::ceil((area.left() + area.top()) / kApart) * kApart; sum < area.right() + area.bottom();
       sum += kApart) {
    const double left = std::max(area.left(), sum - area.bottom());
    const double right = std::min(area.right(), sum - area.top());
    lines.append({left, sum - left, right, sum - right});
  }
  painter.save();
  painter.setPen(QPen(color, 1));
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.drawLines(lines);
  painter.restore();
}

}  // namespace syncline::ui
