// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/language_menu.h"

#include <QActionGroup>
#include <utility>

#include "ui/session/window_memory.h"
#include "ui/text/translations.h"

namespace syncline::ui {

LanguageMenu::LanguageMenu(WindowMemory& memory, std::function<bool()> commit, QWidget* parent)
    : QMenu(tr("Lan&guage"), parent), memory_(memory), commit_(std::move(commit)) {
  setObjectName(QStringLiteral("languageMenu"));
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& language, const QString& text) {
    auto* action = addAction(text);
    action->setObjectName(QStringLiteral("actionLanguage_") + language);
    action->setCheckable(true);
    action->setData(language);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, language] { choose(language); });
  };
  add({}, tr("&System Language"));
  addSeparator();
  for (const auto& language : languages()) add(language.code, language.name);
  showSpoken();
}

void LanguageMenu::showSpoken() {
  const auto spoken = memory_.value(kLanguageSetting).toString();
  for (auto* action : actions()) {
    if (action->isCheckable()) action->setChecked(action->data().toString() == spoken);
  }
}

void LanguageMenu::choose(const QString& language) {
  if (memory_.value(kLanguageSetting).toString() == language) return;
  if (!commit_()) return showSpoken();
  memory_.setValue(kLanguageSetting, language);
  Q_EMIT chosen();
}

}  // namespace syncline::ui
