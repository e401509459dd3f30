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

bool isCommandKey(const QWidget& field, const QKeyEvent& event) {
  const QKeySequence keys(event.keyCombination());
  const auto actions = field.window()->findChildren<QAction*>();
  return std::ranges::any_of(
      actions, [&](const QAction* action) { return action->isEnabled() && action->shortcuts().contains(keys); });
}

void markField(QWidget& field, const QString& reason) {
  constexpr auto kReason = "fieldReason", kToolTip = "fieldToolTip";
  const bool marked = field.property(kReason).isValid();
  if (!marked && reason.isEmpty()) return;
  if (!marked) field.setProperty(kToolTip, field.toolTip());
  field.setProperty(kReason, reason.isEmpty() ? QVariant() : QVariant(reason));
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
    if (field.isVisible()) QToolTip::showText(field.mapToGlobal(field.rect().bottomLeft()), reason, &field);
  };
  QMetaObject::invokeMethod(&field, tell, Qt::QueuedConnection);
}

}  // namespace syncline::ui
