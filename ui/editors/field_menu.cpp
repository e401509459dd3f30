// SPDX-License-Identifier: Apache-2.0
// The context menu of fields: what Qt has there, and the way to the lines of the ENI that depend on the setting.
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMetaMethod>

#include "settings/settings_table.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/field_menu.h"

namespace syncline::ui {

QString FieldBinder::keyOf(const QWidget* widget) const {
  if (widget == nullptr) return {};
  for (const auto& bound : bound_) {
    if (bound.widget != widget && !bound.widget->isAncestorOf(widget)) continue;
    const auto place = bound.place();
    return place ? QString::fromStdString(settings::key_of(*bound.setting, *place)) : QString();
  }
  return {};
}

bool FieldBinder::eventFilter(QObject* watched, QEvent* event) {
  static const auto kWanted = QMetaMethod::fromSignal(&FieldBinder::eniWanted);
  auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() != QEvent::ContextMenu || widget == nullptr || !isSignalConnected(kWanted)) return false;
  const auto key = keyOf(widget);
  if (key.isEmpty()) return false;
  auto* line = qobject_cast<QLineEdit*>(widget);
  if (line == nullptr) line = widget->findChild<QLineEdit*>();
  auto* menu = line != nullptr ? line->createStandardContextMenu() : new QMenu(widget);
  menu->setObjectName(QStringLiteral("fieldMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (!menu->isEmpty()) menu->addSeparator();
  auto* show = menu->addAction(showInEniText());
  show->setObjectName(QStringLiteral("fieldShowInEni"));
  show->setShortcut(kShowInEniKey);
  connect(show, &QAction::triggered, this, [this, key] { Q_EMIT eniWanted(key); });
  menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
  return true;
}

QString showInEniText() { return FieldBinder::tr("Show in &ENI"); }

}  // namespace syncline::ui
