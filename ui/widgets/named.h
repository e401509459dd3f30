// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

namespace syncline::ui {

/// Every control the user can reach has an object name (tests, screenshots) and an accessible name.
template <class Widget>
Widget* named(Widget* widget, const char* object_name, const QString& accessible_name) {
  widget->setObjectName(QLatin1String(object_name));
  widget->setAccessibleName(accessible_name);
  return widget;
}

}  // namespace syncline::ui
