// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/value_transform.h"

#include <algorithm>
#include <cmath>

namespace syncline::ui {
namespace {

constexpr double kLeast = 1e-30;  // of what has a logarithm, in units

}  // namespace

double ValueTransform::place(double value) const {
  switch (scale_) {
    case ValueScale::kSignedLog:
      return std::copysign(std::log10(1 + std::abs(value) / unit_), value);
    case ValueScale::kLog:
      return std::log10(std::max(value / unit_, kLeast));
    case ValueScale::kLinear:
      break;
  }
  return value;
}

double ValueTransform::value(double place) const {
  switch (scale_) {
    case ValueScale::kSignedLog:
      return std::copysign((std::pow(10, std::abs(place)) - 1) * unit_, place);
    case ValueScale::kLog:
      return std::pow(10, place) * unit_;
    case ValueScale::kLinear:
      break;
  }
  return place;
}

}  // namespace syncline::ui
