// SPDX-License-Identifier: Apache-2.0
#include "ui/text/quantity_text.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "ui/text/power_text.h"

namespace syncline::ui {
namespace {

constexpr QChar kNoBreak(0x00A0);

struct ScaledUnit {
  double size;
  const char16_t* name;
};
constexpr std::array<ScaledUnit, 4> kSecondUnits{{{1, u"s"}, {1e-3, u"ms"}, {1e-6, u"\u00B5s"}, {1e-9, u"ns"}}};
constexpr std::array<ScaledUnit, 4> kNanosecondUnits{{{1e9, u"s"}, {1e6, u"ms"}, {1e3, u"\u00B5s"}, {1, u"ns"}}};
constexpr std::array<ScaledUnit, 3> kHertzUnits{{{1e6, u"MHz"}, {1e3, u"kHz"}, {1, u"Hz"}}};

/// Places behind the point that show `digits` of the value.
int placesFor(double value, int digits) {
  return value <= 0 ? 0 : std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(value) + 1e-9)), 0, 9);
}

QString scaledText(std::span<const ScaledUnit> units, double value, int digits) {
  const auto* unit = &units.back();
  for (const auto& one : units) {
    if (value >= one.size * (1 - 1e-9)) {
      unit = &one;
      break;
    }
  }
  const double shown = value / unit->size;
  return QLocale().toString(shown, 'f', placesFor(shown, digits)) + kNoBreak + QString::fromUtf16(unit->name);
}

QString ratioText(double value, int digits) {
  if (value <= 0) return QStringLiteral("0");
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const double mantissa = value / std::pow(10, power);
  const auto ten = powerOfTenText(power);
  if (digits == 1 && std::abs(mantissa - 1) < 1e-6) return ten;
  return QLocale().toString(mantissa, 'f', digits - 1) + QChar(0x00B7) + ten;
}

QString textOfQuantity(Quantity quantity, double value, int digits) {
  switch (quantity) {
    case Quantity::kSeconds:
      return scaledText(kSecondUnits, value, digits);
    case Quantity::kNanoseconds:
      return scaledText(kNanosecondUnits, value, digits);
    case Quantity::kHertz:
      return scaledText(kHertzUnits, value, digits);
    case Quantity::kRatio:
      break;
  }
  return ratioText(value, digits);
}

}  // namespace

QString quantityText(Quantity quantity, double value) { return textOfQuantity(quantity, value, 3); }
QString axisText(Quantity quantity, double value) { return textOfQuantity(quantity, value, 1); }

}  // namespace syncline::ui
