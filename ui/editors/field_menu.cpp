// SPDX-License-Identifier: Apache-2.0
// The context menu of fields: what Qt has there, the default, and the way to the lines of the ENI that depend on the
// setting.
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMetaMethod>
#include <algorithm>

#include "settings/default_value.h"
#include "settings/settings_table.h"
#include "ui/editors/field.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/field_menu.h"
#include "ui/editors/page.h"
#include "ui/session/project_document.h"
#include "ui/text/setting_text.h"

namespace syncline::ui {

const FieldBinder::Bound* FieldBinder::boundOf(const QWidget* widget) const {
  if (widget == nullptr) return nullptr;
  const auto found = std::ranges::find_if(
      bound_, [widget](const Bound& bound) { return bound.widget == widget || bound.widget->isAncestorOf(widget); });
  return found == bound_.end() ? nullptr : &*found;
}

QString FieldBinder::keyOf(const QWidget* widget) const {
  const auto* bound = boundOf(widget);
  const auto place = bound != nullptr ? bound->place() : std::nullopt;
  return place ? QString::fromStdString(settings::key_of(*bound->setting, *place)) : QString();
}

/// What is being typed goes with it: whoever takes the default wants nothing else there.
void FieldBinder::addReset(QMenu& menu, const Bound& bound) {
  const auto place = bound.place();
  const auto& setting = *bound.setting;
  const auto usual = settings::default_value(setting, page_.project(), *place);
  auto* reset = menu.addAction(tr("Reset to &default"));
  reset->setObjectName(QStringLiteral("fieldReset"));
  reset->setEnabled(usual && bound.widget->isEnabled() && *usual != setting.read(page_.project(), *place));
  connect(reset, &QAction::triggered, this, [this, &setting, widget = bound.widget, place = *place, usual] {
    if (auto* field = ui::fieldOf(widget); field != nullptr && field->pending()) field->revert();
    page_.set(tr("Reset: %1").arg(settingLabel(setting)), {{&setting, place, *usual}});
  });
}

bool FieldBinder::eventFilter(QObject* watched, QEvent* event) {
  static const auto kWanted = QMetaMethod::fromSignal(&FieldBinder::eniWanted);
  auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() != QEvent::ContextMenu || widget == nullptr) return false;
  const auto key = keyOf(widget);
  if (key.isEmpty()) return false;
  auto* line = qobject_cast<QLineEdit*>(widget);
  if (line == nullptr) line = widget->findChild<QLineEdit*>();
  auto* menu = line != nullptr ? line->createStandardContextMenu() : new QMenu(widget);
  menu->setObjectName(QStringLiteral("fieldMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (!menu->isEmpty()) menu->addSeparator();
  addReset(*menu, *boundOf(widget));
  if (isSignalConnected(kWanted)) {
    auto* show = menu->addAction(showInEniText());
    show->setObjectName(QStringLiteral("fieldShowInEni"));
    show->setShortcut(kShowInEniKey);
    connect(show, &QAction::triggered, this, [this, key] { Q_EMIT eniWanted(key); });
  }
  menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
  return true;
}

QString showInEniText() { return FieldBinder::tr("Show in &ENI"); }

}  // namespace syncline::ui
