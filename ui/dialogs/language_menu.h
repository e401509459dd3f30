// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>

namespace syncline::ui {

class WindowMemory;

/// The languages of the window, each in its own words. The one chosen is remembered; the next start speaks it, because
/// what is already on the screen keeps its words.
class LanguageMenu final : public QMenu {
  Q_OBJECT

 public:
  explicit LanguageMenu(WindowMemory& memory, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// `text` says when the choice works.
  void chosen(const QString& text);

 private:
  void choose(const QString& language);
  void showNote();

  WindowMemory& memory_;
  QAction* note_ = nullptr;
  QString at_start_;
};

}  // namespace syncline::ui
