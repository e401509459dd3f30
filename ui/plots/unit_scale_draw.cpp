// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/unit_scale_draw.h"

#include <qwt_text.h>

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

namespace syncline::ui {
namespace {

/// "100 ns", "1 ms"; of bare numbers "0.01", "100", "10 000", and powers of ten beyond.
QString decadeText(double value, bool time) {
  constexpr double kLongest = 1e6;
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  double shown = value;
  QString unit;
  if (time && value != 0) {
    const double size = std::abs(value);
    const int step = size < 1e3 ? 0 : size < 1e6 ? 1 : size < 1e9 ? 2 : 3;
    const QString units[] = {QStringLiteral("ns"), QStringLiteral("\u00B5s"), QStringLiteral("ms"),
                             QStringLiteral("s")};
    shown = value / std::pow(1000, step);
    unit = QChar(0x00A0) + units[step];
  }
  auto text = locale.toString(shown, 'g', std::abs(shown) < kLongest ? 6 : 2);
  if (text.startsWith(u'-')) text.replace(0, 1, QChar(0x2212));
  return text + unit;
}

}  // namespace

void UnitScaleDraw::setDivisor(double divisor) {
  if (divisor == divisor_) return;
  divisor_ = divisor;
  invalidateCache();
}

void UnitScaleDraw::setDecades(bool decades, bool times) {
  if (decades == decades_ && times == times_) return;
  decades_ = decades;
  times_ = times;
  invalidateCache();
}

void UnitScaleDraw::setTicks(std::vector<Tick> ticks) {
  if (ticks == ticks_) return;
  ticks_ = std::move(ticks);
  invalidateCache();
}

QwtText UnitScaleDraw::label(double value) const {
  if (!ticks_.empty()) {
    const auto nearest =
        std::ranges::min_element(ticks_, {}, [value](const Tick& tick) { return std::abs(tick.value - value); });
    return QwtText(nearest->label);
  }
  if (decades_) return QwtText(decadeText(value, times_));
  const auto ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
  const double step = ticks.size() > 1 ? std::abs(ticks[1] - ticks[0]) / divisor_ : 1;
  int decimals = 0;
  if (step > 0) decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  double shown = value / divisor_;
  if (std::abs(shown) < step * 1e-6) shown = 0;  // no "-0"
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  auto text = locale.toString(shown, 'f', decimals);
  if (text.startsWith(u'-')) text.replace(0, 1, QChar(0x2212));
  return QwtText(text);
}

}  // namespace syncline::ui
