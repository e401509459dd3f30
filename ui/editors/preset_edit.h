// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "settings/setting_type.h"
#include "ui/editors/choice_edit.h"
#include "ui/editors/field.h"

namespace syncline::ui {

/// A number that can be typed or taken from usual ones. What is typed stays what it is: nothing completes it.
class PresetEdit final : public ChoiceEdit, public Field {
  Q_OBJECT

 public:
  /// Takes a value; an answer is why it was refused, empty: it was not.
  using Take = std::function<QString(std::int64_t)>;
  PresetEdit(const settings::Number& number, std::span<const std::int64_t> usual, Take take, QWidget* parent = nullptr);

  void showValue(std::int64_t value);
  [[nodiscard]] bool pending() const override { return pending_; }
  bool commit() override;
  void revert() override;

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  settings::Number number_;
  Take take_;
  std::int64_t value_ = 0;
  bool pending_ = false;
};

}  // namespace syncline::ui
