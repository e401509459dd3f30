// SPDX-License-Identifier: Apache-2.0
#include "support/quantile_curve.h"

#include <algorithm>

namespace syncline {

double QuantileCurve::at(double part) const {
  if (points_.empty()) return 0;
  const auto above = std::ranges::lower_bound(points_, part, {}, &Point::part);
  if (above == points_.begin()) return points_.front().value;
  if (above == points_.end()) return points_.back().value;
  const auto& below = *(above - 1);
  return below.value + (above->value - below.value) * (part - below.part) / (above->part - below.part);
}

}  // namespace syncline
