// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>
#include <QWidget>

class QAction;
class QActionGroup;

namespace syncline::ui {

/// A row of buttons of which one is always down, with an action each for menus and keys.
class Segments final : public QWidget {
  Q_OBJECT

 public:
  struct Choice {
    const char* object_name;  // of the action; that of the button ends with "Button"
    QString text, tip;
    QKeySequence shortcut;
  };
  explicit Segments(const QList<Choice>& choices, QWidget* parent = nullptr);

  /// Emits nothing.
  void setCurrent(int choice);
  [[nodiscard]] int current() const;
  [[nodiscard]] const QList<QAction*>& choices() const { return actions_; }

 Q_SIGNALS:
  /// By the user.
  void chosen(int choice);

 private:
  QActionGroup* group_;
  QList<QAction*> actions_;
};

}  // namespace syncline::ui
