// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace syncline::ui {

/// While it lives, the wheel changes no choice, number or slider of the program's windows that has not the focus, and
/// gives none the focus: what scrolls on its way over them scrolls on. Menus and lists that are open are no such
/// fields.
class CalmWheel final : public QObject {
  Q_OBJECT

 public:
  /// Watches the application.
  explicit CalmWheel(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace syncline::ui
