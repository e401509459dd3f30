// SPDX-License-Identifier: Apache-2.0
#include "ui/text/translations.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace syncline::ui {

namespace {

bool install(const QLocale& locale) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (!translator->load(locale, QStringLiteral("syncline"), QStringLiteral("_"), QStringLiteral(":/translations"))) {
    delete translator;
    return false;
  }
  return QCoreApplication::installTranslator(translator);
}

}  // namespace

bool installTranslation(const QString& language) {
  const auto locale = language.isEmpty() ? QLocale::system() : QLocale(language);
  if (!language.isEmpty()) QLocale::setDefault(locale);
  // English has a translation too: it holds the plural forms. What the other one lacks falls back to it.
  const bool english = install(QLocale(QLocale::English));
  return locale.language() == QLocale::English || locale.language() == QLocale::C ? english : install(locale);
}

}  // namespace syncline::ui
