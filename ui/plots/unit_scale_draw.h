// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <qwt_scale_draw.h>

#include <QString>
#include <vector>

namespace syncline::ui {

/// Labels an axis whose coordinates are in a base unit in a handier one, with as many decimals as the
/// distance of the ticks asks for, in the user's locale.
class UnitScaleDraw final : public QwtScaleDraw {
 public:
  /// Labels show value / `divisor`.
  void setDivisor(double divisor);
  /// Labels of powers of ten, each with the unit that suits it where they are times in ns.
  void setDecades(bool decades, bool times);
  /// The ticks are to be these, with these words; none: numbers as ever.
  struct Tick {
    double value = 0;
    QString label;
    bool operator==(const Tick&) const = default;
  };
  void setTicks(std::vector<Tick> ticks);
  [[nodiscard]] double divisor() const { return divisor_; }
  [[nodiscard]] QwtText label(double value) const override;

 private:
  double divisor_ = 1;
  bool decades_ = false, times_ = false;
  std::vector<Tick> ticks_;
};

}  // namespace syncline::ui
