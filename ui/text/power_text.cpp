// SPDX-License-Identifier: Apache-2.0
#include "ui/text/power_text.h"

#include <cstdlib>

namespace syncline::ui {

QString powerOfTenText(int power) {
  static const QString kDigits = QString::fromUtf16(u"\u2070\u00B9\u00B2\u00B3\u2074\u2075\u2076\u2077\u2078\u2079");
  auto text = QStringLiteral("10");
  if (power < 0) text += QChar(0x207B);
  for (const auto digit : QString::number(std::abs(power))) text += kDigits.at(digit.unicode() - u'0');
  return text;
}

}  // namespace syncline::ui
