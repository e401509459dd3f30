// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_scale_draw.h>

namespace syncline::ui {

/// Labels an axis whose coordinates are in a base unit in a handier one, with as many decimals as the
/// distance of the ticks asks for, in the user's locale.
class UnitScaleDraw final : public QwtScaleDraw {
 public:
  /// Labels show value / `divisor`.
  void setDivisor(double divisor);
  [[nodiscard]] double divisor() const { return divisor_; }
  [[nodiscard]] QwtText label(double value) const override;

 private:
  double divisor_ = 1;
};

}  // namespace syncline::ui
