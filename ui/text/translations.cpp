// SPDX-License-Identifier: Apache-2.0
#include "ui/text/translations.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace syncline::ui {

bool installTranslation(const QString& language) {
  const auto locale = language.isEmpty() ? QLocale::system() : QLocale(language);
  if (!language.isEmpty()) QLocale::setDefault(locale);
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (!translator->load(locale, QStringLiteral("syncline"), QStringLiteral("_"), QStringLiteral(":/translations"))) {
    delete translator;
    return false;
  }
  return QCoreApplication::installTranslator(translator);
}

}  // namespace syncline::ui
