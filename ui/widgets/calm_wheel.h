// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/widget_events.h"

namespace syncline::ui {

/// While it lives, the wheel changes no choice, number or slider of the program's windows that has not the focus, and
/// gives none the focus: what scrolls on its way over them scrolls on. Menus and lists that are open are no such
/// fields.
class CalmWheel final : public WidgetEvents {
  Q_OBJECT

 public:
  using WidgetEvents::WidgetEvents;

 protected:
  bool take(QObject& watched, QEvent& event) override;
};

}  // namespace syncline::ui
