// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/number_edit.h"

#include <QLineEdit>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <algorithm>
#include <utility>

#include "ui/editors/number_text.h"

namespace syncline::ui {

NumberEdit::NumberEdit(const settings::Number& number, Take take, QWidget* parent)
    : QAbstractSpinBox(parent), number_(number), take_(std::move(take)), range_(number.range) {
  setFocusPolicy(Qt::StrongFocus);
  setAlignment(Qt::AlignRight);
  setAccelerated(true);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this] { pending_ = true; });
}

void NumberEdit::showValue(std::int64_t value, const settings::Range& range) {
  value_ = value;
  range_ = range;
  unset_ = false;
  if (pending_) return;
  display();
}

void NumberEdit::showUnset(std::optional<std::int64_t> stands_for, const settings::Range& range) {
  value_ = stands_for.value_or(0);
  range_ = range;
  unset_ = true;
  stands_for_ = stands_for;
  if (pending_) return;
  display();
}

QString NumberEdit::shownText(std::int64_t value) const {
  const auto unit = unitText(number_);
  return numberText(number_, value) + (unit.isEmpty() ? unit : QChar(u' ') + unit);
}

void NumberEdit::display() {
  if (unset_) {
    const auto text = stands_for_ ? QStringLiteral("%1: %2").arg(clear_word_, shownText(*stands_for_)) : clear_word_;
    if (lineEdit()->placeholderText() != text) {
      lineEdit()->setPlaceholderText(text);
      updateGeometry();
    }
  }
  const auto text = unset_ ? QString() : shownText(value_);
  if (lineEdit()->text() != text) lineEdit()->setText(text);
  markField(*this, {});
  setAccessibleDescription(unset_ ? lineEdit()->placeholderText() : QString());  // where others see it in grey
}

bool NumberEdit::taken(const QString& refusal) {
  if (!refusal.isEmpty()) {
    refuseText(*this, refusal);
    return false;
  }
  pending_ = false;
  display();  // the project may say it otherwise, and said so through showValue()
  return true;
}

bool NumberEdit::commit() {
  if (!pending_) return true;
  const auto typed = lineEdit()->text().trimmed();
  if (clear_ && (typed.isEmpty() || typed == clear_word_)) return unset_ ? (revert(), true) : taken(clear_());
  const auto value = parseNumber(number_, lineEdit()->text());
  if (!value) {
    refuseText(*this,
               tr("\"%1\" is no such number: %2")
                   .arg(lineEdit()->text(), QString::fromStdString(settings::range_text(number_, number_.range))));
    return false;
  }
  if (!unset_ && *value == value_) return revert(), true;
  return taken(take_(*value));
}

void NumberEdit::revert() {
  pending_ = false;
  display();
}

void NumberEdit::stepBy(int steps) {
  if (!commit()) return;
  auto next = std::clamp(value_ + steps * numberStep(number_), range_.low, range_.high);
  if (number_.without_zero && next == 0) next = steps > 0 ? 1 : -1;
  if (next == value_) return;
  taken(take_(next));
  selectAll();
}

QAbstractSpinBox::StepEnabled NumberEdit::stepEnabled() const {
  StepEnabled enabled = StepNone;
  if (value_ > range_.low) enabled |= StepDownEnabled;
  if (value_ < range_.high) enabled |= StepUpEnabled;
  return enabled;
}

// What is typed is judged as a whole, when it is taken.
QValidator::State NumberEdit::validate(QString&, int&) const { return QValidator::Acceptable; }

QSize NumberEdit::sizeHint() const {
  ensurePolished();
  const auto unit = unitText(number_);
  int width = 0;
  // Ranges of registers are wider than what stands in them.
  for (const auto end : {std::max<std::int64_t>(number_.range.low, -100'000'000),
                         std::min<std::int64_t>(number_.range.high, 100'000'000)}) {
    width = std::max(width, fontMetrics().horizontalAdvance(numberText(number_, end) + QChar(u' ') + unit));
  }
  width = std::max(width, fontMetrics().horizontalAdvance(lineEdit()->placeholderText()));
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  const QSize text(width + 8, lineEdit()->sizeHint().height());
  return style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, this);
}

bool NumberEdit::event(QEvent* event) { return leavesToCommand(*this, *event) || QAbstractSpinBox::event(event); }

void NumberEdit::keyPressEvent(QKeyEvent* event) {
  const auto key = takeKey(*this, *event);
  if (key == FieldKey::kTaken || key == FieldKey::kGivenUp) selectAll();
  if (key == FieldKey::kNone) QAbstractSpinBox::keyPressEvent(event);
}

void NumberEdit::focusOutEvent(QFocusEvent* event) {
  if (leavesField(*event)) commit();
  QAbstractSpinBox::focusOutEvent(event);
}

}  // namespace syncline::ui
