// SPDX-License-Identifier: Apache-2.0
#include "ui/text/translations.h"

#include <QCoreApplication>
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

bool install(const QLocale& locale, const QString& file) {
  auto* translator = new ClassContextTranslator(QCoreApplication::instance());
  if (!translator->load(locale, file, QStringLiteral("_"), QStringLiteral(":/translations"))) {
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
  const auto window = QStringLiteral("syncline");
  const bool english = install(QLocale(QLocale::English), window);
  if (locale.language() == QLocale::English || locale.language() == QLocale::C) return english;
  install(locale, QStringLiteral("words"));  // of core/findings, whose source is English
  return install(locale, window);
}

}  // namespace syncline::ui
