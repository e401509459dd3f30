// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/widget_events.h"

#include <QCoreApplication>

namespace syncline::ui {

WidgetEvents::WidgetEvents(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool WidgetEvents::eventFilter(QObject* watched, QEvent* event) {
  return watched->isWidgetType() && take(*watched, *event);
}

}  // namespace syncline::ui
