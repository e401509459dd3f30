// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/monitor_view.h"

namespace syncline::ui {

/// From values to places on an axis of that scale and back. Places of logarithmic scales are decades; about zero the
/// signed one is linear up to `unit`, and what the logarithmic one cannot show lies at its lower end.
class ValueTransform {
 public:
  explicit ValueTransform(ValueScale scale = ValueScale::kLinear, double unit = 1) : scale_(scale), unit_(unit) {}

  [[nodiscard]] ValueScale scale() const { return scale_; }
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] double place(double value) const;
  [[nodiscard]] double value(double place) const;

 private:
  ValueScale scale_;
  double unit_;  // > 0
};

}  // namespace syncline::ui
