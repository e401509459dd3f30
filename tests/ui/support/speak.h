// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <QTranslator>

#include "ui/text/translations.h"

namespace syncline::test {

/// The program speaks a language until this goes.
class Speak {
 public:
  explicit Speak(const QString& language) { EXPECT_TRUE(ui::installTranslation(language)) << qPrintable(language); }
  ~Speak() {
    for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
    QLocale::setDefault(QLocale::c());
  }
  Speak(const Speak&) = delete;
  Speak& operator=(const Speak&) = delete;
};

/// All of them but English, in which the sources are written.
inline QList<QString> translatedLanguages() {
  QList<QString> codes;
  for (const auto& language : ui::languages()) {
    if (language.code != QLatin1String("en")) codes.append(language.code);
  }
  return codes;
}

}  // namespace syncline::test
