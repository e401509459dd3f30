// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/course_delegate.h"

#include <QPainter>
#include <algorithm>

#include "ui/models/slave_figures_model.h"
#include "ui/plots/heat_scale.h"

namespace syncline::ui {

void CourseDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const auto course = index.data(SlaveFiguresModel::kCourseRole).value<QVector<float>>();
  if (course.isEmpty()) return;
  const auto room = QRectF(option.rect).adjusted(4, 2, -4, -2);
  const HeatScale scale(option.palette);
  const double wide = room.width() / static_cast<double>(course.size());
  for (qsizetype i = 0; i < course.size(); ++i) {
    if (course[i] < 0) continue;
    // A small one is seen, too.
    const double high = std::max(static_cast<double>(std::min(course[i], 1.0F)) * room.height(), 1.0);
    const QRectF bar(room.left() + static_cast<double>(i) * wide, room.bottom() - high, wide, high);
    painter->fillRect(bar, QColor(scale.color(std::max(course[i], 0.35F))));
  }
}

}  // namespace syncline::ui
