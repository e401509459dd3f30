// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace syncline {

/// A distribution as it was measured: the value that a part of all observations does not exceed. Linear between its
/// points, flat outside of them; without points always 0.
class QuantileCurve {
 public:
  struct Point {
    double part = 0;   // 0 to 1
    double value = 0;  // ns
    bool operator==(const Point&) const = default;
  };
  QuantileCurve() = default;
  /// Parts and values rise, or stay the same.
  QuantileCurve(std::vector<Point> points) : points_(std::move(points)) {}

  /// `part` is 0 to 1. Of a uniform random part: one more observation.
  [[nodiscard]] double at(double part) const;
  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  bool operator==(const QuantileCurve&) const = default;

 private:
  std::vector<Point> points_;
};

}  // namespace syncline
