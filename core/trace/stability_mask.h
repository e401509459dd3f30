// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "support/result.h"

namespace syncline {

struct StabilityPoint;

/// The figures that a mask can be held against.
enum class StabilityFigure : std::uint8_t { kAdev, kTdev, kMtie };
[[nodiscard]] double figure_of(const StabilityPoint& point, StabilityFigure figure);

/// The most that a figure may be at each observation time: points joined by straight lines on logarithmic axes. Before
/// the first and behind the last point (by more than a hundredth) nothing is asked; a single point asks the same at
/// every time.
struct StabilityMask {
  struct Point {
    double tau = 0;    // s, > 0
    double value = 0;  // > 0; ADEV s/s, the others in the unit of the samples
    bool operator==(const Point&) const = default;
  };
  std::vector<Point> points;  // by tau, which rises
  [[nodiscard]] bool empty() const { return points.empty(); }
  [[nodiscard]] std::optional<double> at(double tau) const;
  bool operator==(const StabilityMask&) const = default;
};

/// What the figure can be at most while every value is within `limit` (> 0, unit of the samples): stability_bound() at
/// every observation time. `unit`: of the samples in s.
[[nodiscard]] StabilityMask mask_of_limit(double limit, StabilityFigure figure, double unit);

/// "1ms 100ns; 1s 250ns": observation time and value, points parted by semicolons; a value alone is asked at every
/// time. Times have s, ms, us, ns; without a unit it is s for observation times and ns for values. Those of ADEV have
/// no unit. kBadValue names the point that nobody understands.
[[nodiscard]] Result<StabilityMask> parse_mask(std::string_view text, StabilityFigure figure);

/// A figure held against a mask.
struct MaskVerdict {
  struct Place {
    double tau = 0, value = 0, allowed = 0;
    [[nodiscard]] double ratio() const { return value / allowed; }
  };
  std::size_t compared = 0;       // observation times at which the mask asks something
  std::vector<Place> beyond;      // by tau
  std::optional<Place> tightest;  // with the largest ratio; nothing: nothing was compared
};
[[nodiscard]] MaskVerdict hold_against(std::span<const StabilityPoint> points, StabilityFigure figure,
                                       const StabilityMask& mask);

}  // namespace syncline
