// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/language_menu.h"

#include <QActionGroup>

#include "ui/session/window_memory.h"
#include "ui/text/translations.h"

namespace syncline::ui {

LanguageMenu::LanguageMenu(WindowMemory& memory, QWidget* parent)
    : QMenu(tr("Lan&guage"), parent), memory_(memory), at_start_(memory.value(kLanguageSetting).toString()) {
  setObjectName(QStringLiteral("languageMenu"));
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& language, const QString& text) {
    auto* action = addAction(text);
    action->setObjectName(QStringLiteral("actionLanguage_") + language);
    action->setCheckable(true);
    action->setChecked(language == at_start_);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, language] { choose(language); });
  };
  add({}, tr("&System Language"));
  addSeparator();
  for (const auto& language : languages()) add(language.code, language.name);
  addSeparator();
  note_ = addAction(tr("Applied at the next start"));
  note_->setObjectName(QStringLiteral("languageNote"));
  note_->setEnabled(false);
  showNote();
}

void LanguageMenu::choose(const QString& language) {
  memory_.setValue(kLanguageSetting, language);
  showNote();
  Q_EMIT chosen(note_->isVisible() ? tr("The window speaks this language from the next start on.") : QString());
}

void LanguageMenu::showNote() { note_->setVisible(memory_.value(kLanguageSetting).toString() != at_start_); }

}  // namespace syncline::ui
