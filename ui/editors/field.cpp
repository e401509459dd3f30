// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/field.h"

#include <QAction>
#include <QKeySequence>
#include <QToolTip>
#include <algorithm>

#include "ui/theme/theme.h"

namespace syncline::ui {

Field* fieldOf(QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    if (auto* field = dynamic_cast<Field*>(widget)) return field;
  }
  return nullptr;
}

bool leavesToCommand(const QWidget& field, QEvent& event) {
  if (event.type() != QEvent::ShortcutOverride) return false;
  const QKeySequence keys(static_cast<QKeyEvent&>(event).keyCombination());
  const auto actions = field.window()->findChildren<QAction*>();
  const bool command = std::ranges::any_of(
      actions, [&](const QAction* action) { return action->isEnabled() && action->shortcuts().contains(keys); });
  if (command) event.ignore();
  return command;
}

FieldKey takeKey(Field& field, QKeyEvent& event) {
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    event.accept();
    return field.commit() ? FieldKey::kTaken : FieldKey::kRefused;
  }
  if (event.key() != Qt::Key_Escape || !field.pending()) return FieldKey::kNone;
  event.accept();
  field.revert();
  return FieldKey::kGivenUp;
}

void markField(QWidget& field, const QString& reason) {
  constexpr auto kReason = "fieldReason", kToolTip = "fieldToolTip";
  const bool marked = field.property(kReason).isValid();
  if (!marked && reason.isEmpty()) return;
  if (!marked) field.setProperty(kToolTip, field.toolTip());
  field.setProperty(kReason, reason.isEmpty() ? QVariant() : QVariant(reason));
  if (reason.isEmpty() && QToolTip::text() == field.accessibleDescription()) QToolTip::hideText();
  const auto usual = field.property(kToolTip).toString();
  field.setToolTip(reason.isEmpty() ? usual : reason + QStringLiteral("\n\n") + usual);
  field.setAccessibleDescription(reason);
  auto palette = QPalette();
  if (!reason.isEmpty()) palette.setColor(QPalette::Text, theme::toneColor(field.palette(), theme::Tone::kBad));
  field.setPalette(palette);
}

void refuseText(QWidget& field, const QString& reason) {
  markField(field, reason);
  // Afterwards: the focus that goes on now takes every tip away.
  const auto tell = [&field, reason] {
    if (field.isVisible() && field.accessibleDescription() == reason)
      QToolTip::showText(field.mapToGlobal(field.rect().bottomLeft()), reason, &field);
  };
  QMetaObject::invokeMethod(&field, tell, Qt::QueuedConnection);
}

}  // namespace syncline::ui
