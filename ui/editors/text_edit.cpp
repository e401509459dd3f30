// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/text_edit.h"

#include <utility>

namespace syncline::ui {

TextEdit::TextEdit(Take take, QWidget* parent) : QLineEdit(parent), take_(std::move(take)) {}

void TextEdit::showValue(const QString& text) {
  shown_ = text;
  if (!pending()) revert();
}

bool TextEdit::commit() {
  if (!pending()) return true;
  const auto typed = text();
  if (typed != shown_) {
    if (const auto reason = take_(typed); !reason.isEmpty()) {
      refuseText(*this, reason);
      return false;
    }
  }
  revert();
  return true;
}

void TextEdit::revert() {
  setModified(false);
  if (text() != shown_) setText(shown_);
  markField(*this, {});
}

bool TextEdit::event(QEvent* event) { return leavesToCommand(*this, *event) || QLineEdit::event(event); }

void TextEdit::keyPressEvent(QKeyEvent* event) {
  const auto key = takeKey(*this, *event);
  if (key == FieldKey::kTaken) selectAll();
  if (key == FieldKey::kNone) QLineEdit::keyPressEvent(event);
}

void TextEdit::focusOutEvent(QFocusEvent* event) {
  if (leavesField(*event)) commit();
  QLineEdit::focusOutEvent(event);
}

}  // namespace syncline::ui
