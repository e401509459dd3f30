// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <functional>

namespace syncline::ui {

class WindowMemory;

/// The languages of the window, each in its own words. The one chosen is remembered.
class LanguageMenu final : public QMenu {
  Q_OBJECT

 public:
  /// `commit`: takes what is typed in fields, which the words of another language would take away; false: not now.
  LanguageMenu(WindowMemory& memory, std::function<bool()> commit, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Another one than the window speaks.
  void chosen();

 private:
  void choose(const QString& language);
  void showSpoken();

  WindowMemory& memory_;
  std::function<bool()> commit_;
};

}  // namespace syncline::ui
