// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPalette>
#include <QRgb>
#include <array>

namespace syncline::ui {

/// Colours of magnitudes against a limit. Up to it they run from near the canvas to a strong blue in equal steps of
/// OKLab, so that equal differences look equal in light and dark; above it they are one orange, which nobody takes for
/// a blue, however he sees colours.
class HeatScale {
 public:
  static constexpr int kSteps = 256;

  explicit HeatScale(const QPalette& palette);
  /// `part` of the limit, 0..1; what is above 1 is over it.
  [[nodiscard]] QRgb color(float part) const {
    return part > 1 ? over_ : (*ramp_)[static_cast<std::size_t>(part * (kSteps - 1) + 0.5F)];
  }
  [[nodiscard]] QRgb over() const { return over_; }

 private:
  const std::array<QRgb, kSteps>* ramp_;
  QRgb over_ = 0;
};

/// Hatching of what nothing is known of.
[[nodiscard]] QColor noReadingColor(const QPalette& palette);

}  // namespace syncline::ui
