// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/preset_edit.h"

#include <QLineEdit>
#include <utility>

#include "ui/editors/number_text.h"

namespace syncline::ui {

PresetEdit::PresetEdit(const settings::Number& number, std::span<const std::int64_t> usual, Take take, QWidget* parent)
    : ChoiceEdit(parent), number_(number), take_(std::move(take)) {
  setEditable(true);
  setCompleter(nullptr);
  setInsertPolicy(QComboBox::NoInsert);
  for (const auto value : usual) addItem(numberText(number_, value));
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { pending_ = true; });
  connect(this, &QComboBox::activated, this, [this] {
    pending_ = true;
    commit();
  });
}

void PresetEdit::showValue(std::int64_t value) {
  value_ = value;
  if (!pending_) revert();
}

bool PresetEdit::commit() {
  if (!pending_) return true;
  const auto typed = currentText();
  const auto value = parseNumber(number_, typed);
  const auto reason =
      !value ? tr("\"%1\" is no such number: %2 %3")
                   .arg(typed, QString::fromStdString(settings::range_text(number_, number_.range)), unitText(number_))
      : *value != value_ ? take_(*value)
                         : QString();
  if (!reason.isEmpty()) {
    refuseText(*this, reason);
    return false;
  }
  revert();
  return true;
}

void PresetEdit::revert() {
  pending_ = false;
  const auto text = numberText(number_, value_);
  if (currentText() != text) setEditText(text);
  markField(*this, {});
}

bool PresetEdit::event(QEvent* event) { return leavesToCommand(*this, *event) || ChoiceEdit::event(event); }

void PresetEdit::keyPressEvent(QKeyEvent* event) {
  const auto key = takeKey(*this, *event);
  if (key == FieldKey::kTaken) lineEdit()->selectAll();
  if (key == FieldKey::kNone) ChoiceEdit::keyPressEvent(event);
}

void PresetEdit::focusOutEvent(QFocusEvent* event) {
  if (leavesField(*event)) commit();
  ChoiceEdit::focusOutEvent(event);
}

}  // namespace syncline::ui
