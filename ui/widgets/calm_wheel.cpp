// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/calm_wheel.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QSlider>
#include <QWheelEvent>

namespace syncline::ui {
namespace {

QWidget* turnable(QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  const bool turns = qobject_cast<QComboBox*>(object) != nullptr ||
                     qobject_cast<QAbstractSpinBox*>(object) != nullptr || qobject_cast<QSlider*>(object) != nullptr;
  return turns ? widget : nullptr;
}

}  // namespace

bool CalmWheel::take(QObject& watched, QEvent& event) {
  if (event.type() == QEvent::Polish) {
    if (auto* widget = turnable(&watched); widget != nullptr && widget->focusPolicy() == Qt::WheelFocus)
      widget->setFocusPolicy(Qt::StrongFocus);
  }
  if (event.type() != QEvent::Wheel) return false;
  const auto* widget = turnable(&watched);
  if (widget == nullptr || widget->hasFocus() || widget->isAncestorOf(QApplication::focusWidget())) return false;
  event.ignore();  // so that the application offers it to what the widget stands in
  return true;
}

}  // namespace syncline::ui
