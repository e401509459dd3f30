// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/language_menu.h"

#include <QActionGroup>

#include "ui/session/window_memory.h"
#include "ui/text/translations.h"

namespace syncline::ui {

LanguageMenu::LanguageMenu(WindowMemory& memory, QWidget* parent) : QMenu(tr("Lan&guage"), parent), memory_(memory) {
  setObjectName(QStringLiteral("languageMenu"));
  auto* group = new QActionGroup(this);
  const auto spoken = memory.value(kLanguageSetting).toString();
  const auto add = [&](const QString& language, const QString& text) {
    auto* action = addAction(text);
    action->setObjectName(QStringLiteral("actionLanguage_") + language);
    action->setCheckable(true);
    action->setChecked(language == spoken);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, language] { choose(language); });
  };
  add({}, tr("&System Language"));
  addSeparator();
  for (const auto& language : languages()) add(language.code, language.name);
}

void LanguageMenu::choose(const QString& language) {
  if (memory_.value(kLanguageSetting).toString() == language) return;
  memory_.setValue(kLanguageSetting, language);
  Q_EMIT chosen();
}

}  // namespace syncline::ui
