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
  [[nodiscard]] QString title() const { return heading_->text(); }
  void setTitle(const QString& title) { heading_->setText(title); }
  /// Label and field with a tool tip on both.
  void addRow(const QString& label, QWidget* field, const QString& tool_tip = {});
  /// Field over the whole width.
  void addWide(QWidget* field, const QString& tool_tip = {});
  /// Read-only value that can be selected and copied.
  QLabel* addValue(const char* object_name, const QString& label, const QString& tool_tip = {});

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QLabel* heading_;
  QFormLayout* form_;
};

/// Cards that belong together have their fields one below the other: as wide as the widest label of a row that is
/// shown.
void alignLabels(const QList<Card*>& cards);

/// Columns of cards side by side, as wide as they need and no wider than one reads. Where they do not fit beside each
/// other, the last columns stand below the others, so that a page scrolls in one direction only.
class CardColumns final : public QWidget {
  Q_OBJECT

 public:
  explicit CardColumns(QWidget* parent = nullptr);
  /// `column` counts from 0; cards of a column stand below each other.
  Card* add(int column, const QString& title);
  /// Ends the columns.
  void addStretch() { arrange(); }
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] int widthOf(qsizetype column) const;
  [[nodiscard]] int fitting(int width) const;
  [[nodiscard]] int rows() const;
  void arrange();
  void orderTabs();

  QList<QList<Card*>> columns_;
  QList<class QVBoxLayout*> stacks_;
  QList<int> placed_;  // the stack of each card
  int rows_ = 0;       // in all cards
  int shown_ = 0;      // columns side by side
};

}  // namespace syncline::ui
