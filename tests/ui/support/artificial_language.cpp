// SPDX-License-Identifier: Apache-2.0
#include "artificial_language.h"

#include <QRegularExpression>

namespace syncline::test {
namespace {

QChar markedLetter(QChar letter) {
  static const QString kSmall = QStringLiteral("åƀçđéƒĝĥîĵķļḿñöþɋŕšţûṽŵẋýž");
  static const QString kLarge = QStringLiteral("ÅƁÇĐÉƑĜĤÎĴĶĻḾÑÖÞǪŔŠŢÛṼŴẊÝŽ");
  const auto code = letter.unicode();
  if (code >= u'a' && code <= u'z') return kSmall[code - u'a'];
  if (code >= u'A' && code <= u'Z') return kLarge[code - u'A'];
  return letter;
}

QString spoken(QStringView words, ArtificialLanguage::Length length) {
  static const QString kVowels = QStringLiteral("aeiouAEIOU");
  QString out;
  for (const auto letter : words) {
    out += markedLetter(letter);
    if (length == ArtificialLanguage::Length::kLonger && kVowels.contains(letter))
      out += markedLetter(letter.toLower());
  }
  return out;
}

}  // namespace

QString ArtificialLanguage::marked(const QString& text, Length length) {
  // A plural of core's words, "{count:# frame|# frames}", is words behind its name.
  static const QRegularExpression kKept(QStringLiteral(
      R"(%L?n|%L?\d+|<[a-zA-Z/][^>]*>|&[a-z]+;|\{\w+[:}]|\([^)]*\*[^)]*\)|\b[\w&]+([._]\w+)+\b|\b[A-Z0-9]{2,}\b)"));
  QString out;
  qsizetype from = 0;
  for (auto kept = kKept.globalMatch(text); kept.hasNext();) {
    const auto one = kept.next();
    out += spoken(QStringView(text).mid(from, one.capturedStart() - from), length) + one.captured();
    from = one.capturedEnd();
  }
  return out + spoken(QStringView(text).mid(from), length);
}

}  // namespace syncline::test
