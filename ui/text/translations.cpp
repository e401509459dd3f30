// SPDX-License-Identifier: Apache-2.0
#include "ui/text/translations.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <string_view>

namespace syncline::ui {

namespace {

/// lupdate names a context after the class alone where namespaces are nested in one line; tr() asks with
/// the namespaces.
class ClassContextTranslator final : public QTranslator {
 public:
  using QTranslator::QTranslator;
  [[nodiscard]] QString translate(const char* context, const char* source, const char* disambiguation,
                                  int n) const override {
    constexpr std::string_view kNamespace = "syncline::ui::";
    const std::string_view name(context);
    return QTranslator::translate(name.starts_with(kNamespace) ? context + kNamespace.size() : context, source,
                                  disambiguation, n);
  }
};

template <class Translator>
bool install(const QLocale& locale, const QString& file, const QString& folder) {
  auto* translator = new Translator(QCoreApplication::instance());
  if (!translator->load(locale, file, QStringLiteral("_"), folder)) {
    delete translator;
    return false;
  }
  return QCoreApplication::installTranslator(translator);
}

const QString kFolder = QStringLiteral(":/translations"), kWindow = QStringLiteral("syncline");

}  // namespace

QList<Language> languages() {
  QList<Language> all;
  const auto files = QDir(kFolder).entryList({kWindow + QStringLiteral("_*.qm")}, QDir::Files, QDir::Name);
  for (const auto& file : files) {
    const auto code = file.mid(kWindow.size() + 1).chopped(3);
    const QLocale locale(code);
    // QLocale calls English that of a country.
    const bool english = locale.language() == QLocale::English;
    all.append({code, english ? QStringLiteral("English") : locale.nativeLanguageName()});
  }
  return all;
}

bool installTranslation(const QString& language) {
  for (auto* before : QCoreApplication::instance()->findChildren<QTranslator*>()) delete before;
  const auto locale = language.isEmpty() ? QLocale::system() : QLocale(language);
  QLocale::setDefault(locale);
  // English has a translation too: it holds the plural forms. What the other one lacks falls back to it.
  const bool english = install<ClassContextTranslator>(QLocale(QLocale::English), kWindow, kFolder);
  if (locale.language() == QLocale::English || locale.language() == QLocale::C) return english;
  install<ClassContextTranslator>(locale, QStringLiteral("words"), kFolder);  // of core, whose source is English
  if (!install<ClassContextTranslator>(locale, kWindow, kFolder)) return false;
  // Buttons of dialogs and menus of text fields; Qt's packages bring it, and without it they stay English.
  install<QTranslator>(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  return true;
}

}  // namespace syncline::ui
