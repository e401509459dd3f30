// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/topology_paint.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include "ui/models/cable_counters.h"
#include "ui/panels/node_delegate.h"
#include "ui/theme/theme.h"

namespace syncline::ui::topology {
namespace {

constexpr double kPortRadius = 6.5;
constexpr double kBadgeHeight = 15;

QFont scaled(double factor, bool bold = false) {
  auto font = QApplication::font();
  font.setPointSizeF(font.pointSizeF() * factor);
  if (bold) font.setWeight(QFont::Bold);
  return font;
}

QString secondLine(const QModelIndex& index) {
  const int slave = index.data(NetworkModel::kSlaveRole).toInt();
  return QStringLiteral("%1 \u00b7 %2").arg(slave).arg(index.data(NetworkModel::kAddressRole).toInt());
}

/// Told apart without colour: a triangle where it begins.
QString badgeWords(const CableBadge& badge) {
  return badge.damage == CableDamage::kFirst ? QStringLiteral("\u25B2 ") + badgeText(badge) : badgeText(badge);
}

QFont badgeFont() { return scaled(0.75, true); }

}  // namespace

QPen cablePen(const QPalette& palette, NetworkModel::LinkState link, bool lifted) {
  if (lifted) return {theme::mutedText(palette), 1.5, Qt::DotLine};
  switch (link) {
    case NetworkModel::LinkState::kGood:
      return {theme::toneColor(palette, theme::Tone::kGood), 2.5};
    case NetworkModel::LinkState::kBroken:
      return {theme::toneColor(palette, theme::Tone::kBad), 2.5, Qt::DashLine};
    case NetworkModel::LinkState::kSilent:
      return {theme::toneColor(palette, theme::Tone::kWarning), 2.5, Qt::DashLine};
    case NetworkModel::LinkState::kOffline:
      break;
  }
  return {theme::mutedText(palette), 1.5};
}

void drawBox(QPainter& painter, const QRectF& box, const QPalette& palette, const QModelIndex& index,
             const BoxLook& look) {
  const bool slave = index.data(NetworkModel::kSlaveRole).toInt() >= 0;
  const bool error = index.data(NetworkModel::kErrorRole).toBool();
  const auto frame = look.selected ? palette.color(QPalette::Highlight)
                     : error       ? theme::toneColor(palette, theme::Tone::kBad)
                                   : theme::outline(palette);
  painter.setBrush(palette.color(look.selected ? QPalette::AlternateBase : QPalette::Base));
  painter.setPen(QPen(frame, look.selected || error ? 2 : 1, look.loose ? Qt::DashLine : Qt::SolidLine));
  painter.drawRoundedRect(box, 6, 6);
  if (look.focused) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(frame, 1, Qt::DotLine));
    painter.drawRoundedRect(box.adjusted(3, 3, -3, -3), 4, 4);
  }
  painter.setFont(scaled(0.85, true));
  drawStateBadge(painter, QRectF(box.left() + 10, box.center().y() - 9, 18, 18).toRect(), palette, index);
  const QRectF area = box.adjusted(36, slave ? 6 : 0, -12, slave ? -6 : 0);
  painter.setFont(scaled(0.9));
  painter.setPen(palette.color(QPalette::Text));
  const auto name =
      painter.fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, static_cast<int>(area.width()));
  painter.drawText(area, static_cast<int>((slave ? Qt::AlignTop : Qt::AlignVCenter) | Qt::AlignLeft), name);
  if (!slave) return;
  painter.setFont(scaled(0.78));
  painter.setPen(theme::mutedText(palette));
  painter.drawText(area, Qt::AlignBottom | Qt::AlignLeft, secondLine(index));
  const auto marks = index.data(NetworkModel::kTopologyMarksRole).toStringList().join(QStringLiteral("  "));
  painter.drawText(area, Qt::AlignBottom | Qt::AlignRight, marks);
}

void drawPort(QPainter& painter, const QPointF& centre, QChar letter, const QPalette& palette, const PortLook& look) {
  const auto accent = theme::toneColor(palette, theme::Tone::kAccent);
  const bool lit = look.offered || look.aimed;
  painter.setPen(QPen(lit ? accent : theme::mutedText(palette), lit ? 2 : 1));
  painter.setBrush(look.aimed ? accent : palette.color(look.free ? QPalette::Base : QPalette::Window));
  const double radius = look.aimed ? kPortRadius + 2 : kPortRadius;
  painter.drawEllipse(centre, radius, radius);
  painter.setFont(scaled(0.65));
  painter.setPen(look.aimed ? palette.color(QPalette::HighlightedText) : palette.color(QPalette::Text));
  painter.drawText(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius), Qt::AlignCenter, letter);
}

QSizeF badgeSize(const CableBadge& badge) {
  return {QFontMetricsF(badgeFont()).horizontalAdvance(badgeWords(badge)) + 10, kBadgeHeight};
}

void drawBadge(QPainter& painter, const QRectF& area, const QPalette& palette, const CableBadge& badge) {
  const bool first = badge.damage == CableDamage::kFirst, forwarded = badge.damage == CableDamage::kForwarded;
  const auto tone = first ? theme::Tone::kBad : theme::Tone::kWarning;
  const auto color = theme::toneColor(palette, tone);
  painter.setPen(QPen(color, 1, forwarded ? Qt::DotLine : Qt::SolidLine));
  painter.setBrush(first ? color : forwarded ? palette.color(QPalette::Base) : theme::toneFill(palette, tone));
  painter.drawRoundedRect(area, area.height() / 2, area.height() / 2);
  painter.setFont(badgeFont());
  painter.setPen(first ? palette.color(QPalette::Base) : color);
  painter.drawText(area, Qt::AlignCenter, badgeWords(badge));
}

}  // namespace syncline::ui::topology
