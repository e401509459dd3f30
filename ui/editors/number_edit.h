// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractSpinBox>
#include <functional>
#include <optional>
#include <utility>

#include "settings/setting_type.h"
#include "ui/editors/field.h"

namespace syncline::ui {

/// A number of a setting, exact. Only what a user does reaches `taken`: showing a value or a range tells nobody. What
/// is typed is taken by Enter, by leaving the field or by a command of the window.
class NumberEdit final : public QAbstractSpinBox, public Field {
  Q_OBJECT

 public:
  /// Takes a value; an answer is why it was refused, empty: it was not.
  using Take = std::function<QString(std::int64_t)>;

  NumberEdit(const settings::Number& number, Take take, QWidget* parent = nullptr);
  /// What an emptied field means: the setting is unset, which `word` says. Without it an empty field is no value.
  void setClear(const QString& word, std::function<QString()> clear) {
    clear_word_ = word;
    clear_ = std::move(clear);
  }

  /// Shows `value`; the arrows stay within `range`. Text that is pending stays.
  void showValue(std::int64_t value, const settings::Range& range);
  /// The setting is unset: the empty field says so, and what stands for it where that is known.
  void showUnset(std::optional<std::int64_t> stands_for, const settings::Range& range);
  [[nodiscard]] std::int64_t value() const { return value_; }
  [[nodiscard]] const settings::Range& range() const { return range_; }

  [[nodiscard]] bool pending() const override { return pending_; }
  bool commit() override;
  void revert() override;

  void stepBy(int steps) override;
  QValidator::State validate(QString& text, int& position) const override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  [[nodiscard]] StepEnabled stepEnabled() const override;

 private:
  [[nodiscard]] QString shownText(std::int64_t value) const;
  void display();
  bool taken(const QString& refusal);

  settings::Number number_;
  Take take_;
  QString clear_word_;
  std::function<QString()> clear_;
  bool unset_ = false;
  std::optional<std::int64_t> stands_for_;
  std::int64_t value_ = 0;
  settings::Range range_;
  bool pending_ = false;
};

}  // namespace syncline::ui
