// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heat_scale.h"

#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

/// OKLab: lightness, green to red, blue to yellow.
struct Oklab {
  double lightness, a, b;
};

int channel(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  const double coded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255 * coded));
}

QRgb rgbOf(const Oklab& color) {
  const auto cube = [](double root) { return root * root * root; };
  const double l = cube(color.lightness + 0.3963377774 * color.a + 0.2158037573 * color.b);
  const double m = cube(color.lightness - 0.1055613458 * color.a - 0.0638541728 * color.b);
  const double s = cube(color.lightness - 0.0894841775 * color.a - 1.2914855480 * color.b);
  return qRgb(channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
              channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
              channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

using Ramp = std::array<QRgb, HeatScale::kSteps>;

Ramp rampOf(const Oklab& from, const Oklab& to) {
  Ramp ramp{};
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    const double part = static_cast<double>(i) / (HeatScale::kSteps - 1);
    ramp[i] = rgbOf(
        {std::lerp(from.lightness, to.lightness, part), std::lerp(from.a, to.a, part), std::lerp(from.b, to.b, part)});
  }
  return ramp;
}

constexpr Oklab kQuietOnLight{0.93, -0.012, -0.022}, kStrongOnLight{0.36, -0.015, -0.125};
constexpr Oklab kQuietOnDark{0.34, -0.012, -0.050}, kStrongOnDark{0.88, -0.050, -0.060};
constexpr QRgb kOverOnLight = 0xFFE8590C, kOverOnDark = 0xFFFF7A1A;

}  // namespace

HeatScale::HeatScale(const QPalette& palette) {
  static const Ramp on_light = rampOf(kQuietOnLight, kStrongOnLight);
  static const Ramp on_dark = rampOf(kQuietOnDark, kStrongOnDark);
  const bool dark = theme::isDark(palette);
  ramp_ = dark ? &on_dark : &on_light;
  over_ = dark ? kOverOnDark : kOverOnLight;
}

QColor noReadingColor(const QPalette& palette) {
  return QColor::fromRgb(theme::isDark(palette) ? 0xFF55606B : 0xFFB4BCC5);
}

}  // namespace syncline::ui
