// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/number_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <string>

#include "settings/number_text.h"
#include "settings/setting_type.h"

namespace syncline::ui {

QString numberText(const settings::Number& number, std::int64_t value) {
  if (number.hex_digits > 0) return QString::fromStdString(settings::format_value(number, value));
  if (!number.nanoseconds_as_us) return QString::number(value);
  auto text = QString::fromStdString(settings::format_microseconds(value));
  return text.replace(u'.', QLocale().decimalPoint());
}

QString unitText(const settings::Number& number) {
  if (number.unit == "us") return QStringLiteral("\u00B5s");
  if (number.unit == "ppt") return QStringLiteral("\u2030");
  return QCoreApplication::translate("Setting", std::string(number.unit).c_str());  // words like "frames"
}

std::optional<std::int64_t> parseNumber(const settings::Number& number, QString text) {
  text.replace(QChar(0x2212), u'-').replace(QChar(0x03BC), QChar(0x00B5));  // minus sign, Greek mu
  const auto unit = unitText(number);
  text = text.trimmed();
  if (!unit.isEmpty() && text.endsWith(unit)) text.chop(unit.size());
  if (number.nanoseconds_as_us && text.endsWith(QStringLiteral("us"))) text.chop(2);
  text = text.trimmed().replace(QLocale().decimalPoint(), QStringLiteral("."));
  const auto plain = text.toStdString();
  return number.nanoseconds_as_us ? settings::parse_microseconds(plain) : settings::parse_integer(plain);
}

std::int64_t numberStep(const settings::Number& number) { return number.nanoseconds_as_us ? kMicrosecond : 1; }

}  // namespace syncline::ui
