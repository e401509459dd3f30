// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QTranslator>

namespace syncline::test {

/// A language that nobody speaks, made of the sources, in which each letter carries a mark: "Deviation" is "Đéṽîåţîöñ".
/// What is shown without marks never went through a translation (plain_words). `Length::kLonger`: vowels are double,
/// which makes texts a third longer; what is cut in it would be cut in the next language. The program speaks it while
/// this lives, also where another one was installed before.
class ArtificialLanguage final : public QTranslator {
 public:
  enum class Length : unsigned char { kSame, kLonger };
  explicit ArtificialLanguage(Length length = Length::kSame) : length_(length) {
    QCoreApplication::installTranslator(this);
  }
  ~ArtificialLanguage() override { QCoreApplication::removeTranslator(this); }

  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/,
                                  int /*n*/) const override {
    return marked(QString::fromUtf8(source), length_);
  }
  /// Placeholders (%1, %n, {name}), tags, entities, patterns of file names, keys of settings and names in capitals
  /// (INIT, DC, 1C32) stay.
  [[nodiscard]] static QString marked(const QString& text, Length length = Length::kSame);

 private:
  Length length_;
};

}  // namespace syncline::test
