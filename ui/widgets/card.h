// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QWidget>

namespace syncline::ui {

/// A titled area of a page: rounded outline on the base colour, a form inside.
class Card final : public QWidget {
  Q_OBJECT

 public:
  explicit Card(const QString& title, QWidget* parent = nullptr);

  [[nodiscard]] QFormLayout* form() { return form_; }
  /// Label and field with a tool tip on both.
  void addRow(const QString& label, QWidget* field, const QString& tool_tip = {});
  /// Field over the whole width.
  void addWide(QWidget* field, const QString& tool_tip = {});
  /// Read-only value that can be selected and copied.
  QLabel* addValue(const char* object_name, const QString& label, const QString& tool_tip = {});

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFormLayout* form_;
};

/// Columns of cards side by side, as wide as they need; scrolls when the page is too small.
class CardColumns final : public QWidget {
  Q_OBJECT

 public:
  explicit CardColumns(QWidget* parent = nullptr);
  /// `column` counts from 0; cards of a column stand below each other.
  Card* add(int column, const QString& title);
  void addStretch();

 private:
  QList<class QVBoxLayout*> columns_;
};

}  // namespace syncline::ui
