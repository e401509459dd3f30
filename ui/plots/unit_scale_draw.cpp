// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/unit_scale_draw.h"

#include <qwt_text.h>

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace syncline::ui {

void UnitScaleDraw::setDivisor(double divisor) {
  if (divisor == divisor_) return;
  divisor_ = divisor;
  invalidateCache();
}

QwtText UnitScaleDraw::label(double value) const {
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
