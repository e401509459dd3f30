// SPDX-License-Identifier: Apache-2.0
#include "ui/text/units.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <cstdlib>

#include "ui/text/power_text.h"

namespace syncline::ui {
namespace {

constexpr QChar kNoBreakSpace(0x00A0);

/// As the axes of the plots have it: a hyphen is no minus.
QString withMinus(QString number) {
  if (number.startsWith(u'-')) number.replace(0, 1, QChar(0x2212));
  return number;
}

QString withUnit(const QString& number, const QString& unit) { return withMinus(number) + kNoBreakSpace + unit; }

QString microUnit() { return QStringLiteral("\u00B5s"); }

/// Number without trailing zeros, at most `decimals`.
QString trimmed(double value, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  auto text = locale.toString(value, 'f', decimals);
  const auto point = locale.decimalPoint();
  if (text.contains(point)) {
    while (text.endsWith(u'0')) text.chop(1);
    if (text.endsWith(point)) text.chop(point.size());
  }
  return text;
}

}  // namespace

QString timeText(Nanoseconds value) {
  const QLocale locale;
  const auto magnitude = std::llabs(value);
  const auto number = static_cast<double>(value);
  if (magnitude < kMicrosecond) return withUnit(locale.toString(static_cast<qlonglong>(value)), QStringLiteral("ns"));
  if (magnitude < kMillisecond) return withUnit(locale.toString(number / 1e3, 'f', 3), microUnit());
  if (magnitude < kSecond) return withUnit(locale.toString(number / 1e6, 'f', 3), QStringLiteral("ms"));
  return withUnit(locale.toString(number / 1e9, 'f', 3), QStringLiteral("s"));
}

QString signedTimeText(Nanoseconds value) { return value > 0 ? u'+' + timeText(value) : timeText(value); }

QString atMostText(const QString& estimate) { return QStringLiteral("\u2264 ") + estimate; }
Nanoseconds wholeNs(double value) { return static_cast<Nanoseconds>(std::llround(value)); }

QString runTimeText(Nanoseconds since_begin) {
  return withUnit(QLocale().toString(static_cast<double>(since_begin) / 1e9, 'f', 3), QStringLiteral("s"));
}

QString cycleText(Nanoseconds value) {
  const auto number = static_cast<double>(value);
  if (std::llabs(value) < kMicrosecond) return withUnit(trimmed(number, 0), QStringLiteral("ns"));
  if (std::llabs(value) < kMillisecond) return withUnit(trimmed(number / 1e3, 3), microUnit());
  return withUnit(trimmed(number / 1e6, 6), QStringLiteral("ms"));
}

QString ppmText(double ppm) {
  const double shown = std::round(ppm * 100) / 100 + 0.0;  // + 0.0: no "-0.00"
  const auto text = withUnit(QLocale().toString(shown, 'f', 2), QStringLiteral("ppm"));
  return shown > 0 ? u'+' + text : text;
}

QString withSpreadText(const QString& estimate, const std::optional<double>& half_width_ns) {
  if (!half_width_ns) return estimate;
  const auto half = static_cast<Nanoseconds>(std::ceil(*half_width_ns));
  return QStringLiteral("%1 \u00B1 %2").arg(estimate, timeText(half));
}

QString withSpreadPpmText(double ppm, const std::optional<double>& half_width) {
  if (!half_width) return ppmText(ppm);
  // Whoever is sure to a thousandth sees it.
  const int digits = *half_width < 0.01 ? 3 : 2;
  const double scale = digits == 3 ? 1000 : 100;
  const auto number = [&](double value) { return withMinus(QLocale().toString(value, 'f', digits)); };
  const double shown = std::round(ppm * scale) / scale + 0.0;
  return (shown > 0 ? QStringLiteral("+") : QString()) + QStringLiteral("%1 \u00B1 ").arg(number(shown)) +
         withUnit(number(std::ceil(*half_width * scale) / scale), QStringLiteral("ppm"));
}

QString decadeText(int decades_below_one) {
  return decades_below_one == 0 ? QStringLiteral("1") : powerOfTenText(-decades_below_one);
}

QString countDecadeText(int decade) {
  constexpr int kWrittenOut = 4;
  return decade < kWrittenOut ? QLocale().toString(std::pow(10, decade), 'f', 0) : powerOfTenText(decade);
}

QString countText(std::uint64_t value) { return QLocale().toString(static_cast<qulonglong>(value)); }

QString numberText(double value) {
  constexpr double kLongest = 1e10;
  const bool whole = value == std::floor(value) && std::abs(value) < kLongest;
  return whole ? QLocale().toString(value, 'f', 0) : QLocale().toString(value, 'g', 7);
}

QString hexText(std::uint64_t value, int digits) {
  return QStringLiteral("0x%1")
      .arg(static_cast<qulonglong>(value), digits, 16, QLatin1Char('0'))
      .toUpper()
      .replace(QLatin1Char('X'), QLatin1Char('x'));
}

QString objectText(std::uint16_t index, std::uint8_t sub_index) {
  return QStringLiteral("%1:%2").arg(hexText(index, 4), hexText(sub_index, 2).mid(2));
}

QString bitsText(std::uint32_t bits) {
  const bool whole = bits % 8 == 0;
  const int count = static_cast<int>(whole ? bits / 8 : bits);
  if (whole) return QCoreApplication::translate("Units", "%n Byte(s)", nullptr, count);
  return QCoreApplication::translate("Units", "%n Bit(s)", nullptr, count);
}

QString noText() { return QStringLiteral("\u2013"); }

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

}  // namespace syncline::ui
