// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/node_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QStringList>
#include <algorithm>

#include "ui/models/network_model.h"
#include "ui/text/glossary.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr int kBadge = 18;
constexpr int kMargin = 4;

/// Position or address, at a side of the area; returns the width that it took.
int drawNumber(QPainter& painter, const QRect& area, const QFont& font, const QColor& color, const QString& number,
               Qt::Alignment side) {
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(area, static_cast<int>(side | Qt::AlignVCenter), number);
  const QFontMetrics metrics(font);
  return std::max(metrics.horizontalAdvance(number), metrics.horizontalAdvance(QStringLiteral("00"))) + kMargin + 2;
}

/// Returns the width that the marks took.
int drawMarks(QPainter& painter, const QRect& row, const QStringList& marks, const QColor& color,
              const QFontMetrics& metrics) {
  int right = row.right() - kMargin;
  for (const auto& mark : marks) {
    const int width = metrics.horizontalAdvance(mark) + 8;
    const QRect box(right - width, row.center().y() - metrics.height() / 2, width, metrics.height() + 1);
    painter.setPen(color);
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter.drawText(box, Qt::AlignCenter, mark);
    right -= width + kMargin;
  }
  return row.right() - right;
}

/// A slave is usually called "Slave_1001 [type]": where that does not fit, the type stands beside the name in small
/// letters, and it is the type that ends before its end.
void drawName(QPainter& painter, const QRect& area, const QFont& font, const QFont& small, const QString& name) {
  const QFontMetrics metrics(font);
  const auto bracket = name.endsWith(u']') ? name.lastIndexOf(QStringLiteral(" [")) : -1;
  const auto own = name.left(bracket);
  const int wide = metrics.horizontalAdvance(own) + kMargin;
  const bool whole = metrics.horizontalAdvance(name) <= area.width();
  painter.setFont(font);
  if (whole || bracket <= 0 || wide >= area.width()) {
    return painter.drawText(area, Qt::AlignVCenter | Qt::AlignLeft,
                            metrics.elidedText(name, Qt::ElideRight, area.width()));
  }
  painter.drawText(area, Qt::AlignVCenter | Qt::AlignLeft, own);
  painter.setFont(small);
  const auto type = QFontMetrics(small).elidedText(name.mid(bracket + 1), Qt::ElideRight, area.width() - wide);
  painter.drawText(area.adjusted(wide, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, type);
}

/// The least that drawName() needs.
int nameWidth(const QString& name, const QFontMetrics& metrics, const QFontMetrics& small) {
  const auto bracket = name.endsWith(u']') ? name.lastIndexOf(QStringLiteral(" [")) : -1;
  if (bracket <= 0) return metrics.horizontalAdvance(name);
  return metrics.horizontalAdvance(name.left(bracket)) + kMargin + small.horizontalAdvance(name.mid(bracket + 1));
}

}  // namespace

void drawStateBadge(QPainter& painter, const QRect& box, const QPalette& palette, const QModelIndex& index) {
  const int state = index.data(NetworkModel::kStateRole).toInt();
  const bool error = index.data(NetworkModel::kErrorRole).toBool();
  if (state < 0) {
    painter.setPen(QPen(theme::outline(palette), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    return;
  }
  const auto tone = error ? theme::Tone::kBad : theme::stateTone(static_cast<AlState>(state));
  const auto color = theme::toneColor(palette, tone);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(box, 4, 4);
  painter.setPen(theme::isDark(palette) ? palette.color(QPalette::Base) : QColor(Qt::white));
  auto letter = stateLetter(static_cast<AlState>(state));
  if (error) letter += u'!';
  painter.drawText(box, Qt::AlignCenter, letter);
}

void NodeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  const auto name = row.text;
  row.text.clear();
  const auto* style = row.widget != nullptr ? row.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);

  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const bool selected = (row.state & QStyle::State_Selected) != 0;
  const bool other = index.data(NetworkModel::kOtherRole).toBool() && !selected;
  const auto text = other ? theme::mutedText(row.palette)
                          : row.palette.color(QPalette::Active, selected ? QPalette::HighlightedText : QPalette::Text);
  auto small = row.font;
  small.setPointSizeF(small.pointSizeF() * 0.8);
  const QRect badge(row.rect.left() + kMargin, row.rect.center().y() - kBadge / 2 + 1, kBadge, kBadge);
  auto bold = row.font;
  bold.setPointSizeF(bold.pointSizeF() * 0.9);
  bold.setWeight(QFont::Bold);
  painter->setFont(bold);
  drawStateBadge(*painter, badge, row.palette, index);
  painter->setFont(small);
  const int marks = drawMarks(*painter, row.rect, index.data(NetworkModel::kMarksRole).toStringList(),
                              selected ? text : theme::mutedText(row.palette), QFontMetrics(small));
  QRect area(badge.right() + 8, row.rect.top(), row.rect.right() - badge.right() - 10 - marks, row.rect.height());
  if (const int slave = index.data(NetworkModel::kSlaveRole).toInt(); slave >= 0) {
    const auto quiet = selected ? text : theme::mutedText(row.palette);
    area.setLeft(area.left() + drawNumber(*painter, area, small, quiet, QString::number(slave), Qt::AlignLeft));
    const auto address = QString::number(index.data(NetworkModel::kAddressRole).toInt());
    const int room =
        area.width() - row.fontMetrics.horizontalAdvance(name) - QFontMetrics(small).horizontalAdvance(address);
    if (room > 2 * kMargin && !name.contains(address))
      drawNumber(*painter, area, small, quiet, address, Qt::AlignRight);
  }
  painter->setPen(text);
  drawName(*painter, area, row.font, small, name);
  painter->restore();
}

QSize NodeDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  auto size = QStyledItemDelegate::sizeHint(option, index);
  size.setHeight(std::max(size.height(), kBadge + 8));
  auto small = option.font;
  small.setPointSizeF(small.pointSizeF() * 0.8);
  const QFontMetrics metrics(small);
  int width = kMargin + kBadge + 18 + nameWidth(index.data().toString(), option.fontMetrics, metrics);
  if (const int slave = index.data(NetworkModel::kSlaveRole).toInt(); slave >= 0) {
    const auto number = std::max(QString::number(slave), QStringLiteral("00"),
                                 [](const QString& left, const QString& right) { return left.size() < right.size(); });
    width += metrics.horizontalAdvance(number) + kMargin + 2;
  }
  for (const auto& mark : index.data(NetworkModel::kMarksRole).toStringList())
    width += metrics.horizontalAdvance(mark) + 8 + kMargin;
  size.setWidth(width);
  return size;
}

}  // namespace syncline::ui
