// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/plot_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/theme.h"

namespace syncline::ui::plot_colors {
namespace {

constexpr std::array<QRgb, kTraceCount> kOnLight{0xFF0072B2, 0xFFD55E00, 0xFF009E73,
                                                 0xFFA84C82, 0xFF8A5A2B, 0xFF2B2F77};
constexpr std::array<QRgb, kTraceCount> kOnDark{0xFF56B4E9, 0xFFE69F00, 0xFF2BBF94, 0xFFD070B0, 0xFFF0E442, 0xFFF0793A};

QColor pick(const QPalette& palette, QRgb light, QRgb dark) {
  return QColor::fromRgba(theme::isDark(palette) ? dark : light);
}

double luminance(const QColor& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

}  // namespace

QColor trace(const QPalette& palette, int slot) {
  const auto index = static_cast<std::size_t>(slot < 0 ? 0 : slot) % kTraceCount;
  return pick(palette, kOnLight[index], kOnDark[index]);
}

QColor envelope(const QPalette& palette) { return pick(palette, 0xFF8793A0, 0xFF7A8794); }
QColor overlay(const QPalette& palette) { return pick(palette, 0x9E7B4FA8, 0x9EC39BEA); }
QColor grid(const QPalette& palette) { return pick(palette, 0xFFE6EAEE, 0xFF2A323B); }
QColor limitLine(const QPalette& palette) { return theme::toneColor(palette, theme::Tone::kBad); }
QColor limitFill(const QPalette& palette) { return pick(palette, 0x1400845F, 0x182BBF94); }
QColor cursor(const QPalette& palette) { return palette.color(QPalette::Text); }

double contrast(const QColor& a, const QColor& b) {
  const double first = luminance(a) + 0.05;
  const double second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

}  // namespace syncline::ui::plot_colors
