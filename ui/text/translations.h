// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>

namespace syncline::ui {

/// Name of the remembered setting: code of the language, nothing for the desktop's.
inline const QString kLanguageSetting = QStringLiteral("language");

struct Language {
  QString code;  // as QLocale takes it: "de", "zh_CN"
  QString name;  // in the language itself
};

/// The languages that the window has, English among them, ordered by code.
QList<Language> languages();

/// Installs the translation of a language ("de"; "" = the desktop's), that of Qt's own dialogs where Qt has it, and
/// the matching number format. False when there is none: the window then speaks English.
bool installTranslation(const QString& language);

}  // namespace syncline::ui
