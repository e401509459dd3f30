// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <functional>

#include "ui/editors/field.h"

namespace syncline::ui {

/// A text of a setting; taken by Enter, by leaving the field or by a command of the window.
class TextEdit final : public QLineEdit, public Field {
  Q_OBJECT

 public:
  /// Takes a text; an answer is why it was refused, empty: it was not.
  using Take = std::function<QString(const QString&)>;
  explicit TextEdit(Take take, QWidget* parent = nullptr);

  /// Shows `text` without telling anybody. Text that is pending stays.
  void showValue(const QString& text);
  [[nodiscard]] bool pending() const override { return isModified(); }
  bool commit() override;
  void revert() override;

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  Take take_;
  QString shown_;
};

}  // namespace syncline::ui
