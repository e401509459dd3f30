// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/window_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOptionTab>

namespace syncline::ui::theme {
namespace {

constexpr int kLine = 3;  // pixels at scale 1

/// The part of a tab that lies farthest from its page.
QRect outerEdge(const QStyleOptionTab& tab) {
  QRect edge = tab.rect;
  switch (tab.shape) {
    case QTabBar::RoundedSouth:
    case QTabBar::TriangularSouth:
      edge.setTop(edge.bottom() - kLine + 1);
      break;
    case QTabBar::RoundedWest:
    case QTabBar::TriangularWest:
      edge.setWidth(kLine);
      break;
    case QTabBar::RoundedEast:
    case QTabBar::TriangularEast:
      edge.setLeft(edge.right() - kLine + 1);
      break;
    default:
      edge.setHeight(kLine);
      break;
  }
  return edge;
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void WindowStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  QProxyStyle::drawControl(element, option, painter, widget);
  const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
  if (element != CE_TabBarTabShape || tab == nullptr || !tab->state.testFlag(State_Selected)) return;
  painter->fillRect(outerEdge(*tab), tab->palette.color(QPalette::Active, QPalette::Highlight));
}

}  // namespace syncline::ui::theme
