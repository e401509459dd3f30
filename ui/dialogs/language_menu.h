// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>

namespace syncline::ui {

class WindowMemory;

/// The languages of the window, each in its own words. The one chosen is remembered.
class LanguageMenu final : public QMenu {
  Q_OBJECT

 public:
  explicit LanguageMenu(WindowMemory& memory, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Another one than the window speaks.
  void chosen();

 private:
  void choose(const QString& language);

  WindowMemory& memory_;
};

}  // namespace syncline::ui
