// SPDX-License-Identifier: Apache-2.0
#include "ui/text/typed_value.h"

#include <QLocale>
#include <QRegularExpression>
#include <cmath>

#include "ui/text/as_typed.h"

namespace syncline::ui {
namespace {

struct Typed {
  QString number, unit;
};

std::optional<Typed> taken(QString text) {
  text = asTyped(text.trimmed().remove(QChar(0x00A0)));
  text.replace(QLocale().decimalPoint(), QStringLiteral("."));
  static const QRegularExpression form(
      QStringLiteral("^([+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?)\\s*(ns|us|ms|s)?$"));
  const auto match = form.match(text);
  if (!match.hasMatch()) return std::nullopt;
  return Typed{match.captured(1), match.captured(2)};
}

/// Decimal places of the unit above ns.
int placesOf(const QString& unit) {
  if (unit == QStringLiteral("us")) return 3;
  if (unit == QStringLiteral("ms")) return 6;
  return unit == QStringLiteral("s") ? 9 : 0;
}

}  // namespace

std::optional<double> typedValue(const QString& text, bool times) {
  const auto typed = taken(text);
  if (!typed || (!times && !typed->unit.isEmpty())) return std::nullopt;
  bool ok = false;
  const double value = typed->number.toDouble(&ok) * std::pow(10, placesOf(typed->unit));
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Nanoseconds> typedTime(const QString& text) {
  const auto typed = taken(text);
  if (!typed || typed->number.contains(u'e', Qt::CaseInsensitive)) return std::nullopt;
  const int places = typed->unit.isEmpty() ? 6 : placesOf(typed->unit);
  auto whole = typed->number.section(u'.', 0, 0);
  auto part = typed->number.section(u'.', 1);
  if (part.size() > places) {
    // What is finer than a nanosecond is none of ours.
    if (part.sliced(places).count(u'0') != part.size() - places) return std::nullopt;
    part.truncate(places);
  }
  bool ok = false;
  const auto value = (whole + part.leftJustified(places, u'0')).toLongLong(&ok);
  return ok ? std::optional<Nanoseconds>(value) : std::nullopt;
}

std::optional<Nanoseconds> typedDistance(const QString& text) {
  const auto trimmed = text.trimmed();
  if (!trimmed.endsWith(QStringLiteral("Hz"), Qt::CaseInsensitive)) {
    const auto time = typedTime(trimmed);
    return time == 0 ? std::nullopt : time;
  }
  const auto frequency = typedValue(trimmed.chopped(2), false);
  if (!frequency || *frequency == 0) return std::nullopt;
  const double period = 1e9 / *frequency;
  if (std::abs(period) < 1 || std::abs(period) > 1e17) return std::nullopt;
  return static_cast<Nanoseconds>(std::llround(period));
}

QString valueToType(double value) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, 'g', 10);
}

}  // namespace syncline::ui
