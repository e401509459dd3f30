// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// Intervals that hold the true value in 95 of 100 cases, of readings that have to do with those before them.
///
/// Both ask the slowest movements of the readings, as cosines over the whole of them: a mean and a rate are only as
/// sure as these are small, and each of them counts for itself, which is what Student's t needs to be exact (Mueller
/// 2007; Lazarus, Lewis, Stock, Watson 2018: equal-weighted cosine estimator of a long-run variance).
namespace syncline {

/// 95 % interval of a figure, in its unit.
struct Interval {
  double low = 0, high = 0;
  bool operator==(const Interval&) const = default;
  [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
};

/// Two-sided 95 % point of Student's t. `freedom`: degrees of freedom, from 1 on; of none it is that of one.
[[nodiscard]] double student_95(std::size_t freedom);

/// The 95 % interval of the mean of what `means` are the means of, each of as many readings, in their order; its ends
/// are told as distances from that mean. Where rare readings lie far to one side it reaches further there (Willink
/// 2005, after Hall). Nothing where they are fewer than kFewestMeans, or where they still resemble their neighbours so
/// much that the whole of them says little of what would come next. Allocates nothing.
inline constexpr std::size_t kFewestMeans = 16;
[[nodiscard]] std::optional<Interval> mean_interval(std::span<const double> means);

/// Half of the 95 % interval of the slope of the line of least squares through (x, y): of y's unit by x's. `x` about
/// evenly spaced. Nothing with fewer than kFewestPoints, or more than kMostPoints. Allocates nothing.
inline constexpr std::size_t kFewestPoints = 6, kMostPoints = 128;
[[nodiscard]] std::optional<double> slope_half_width(std::span<const double> x, std::span<const double> y);

}  // namespace syncline
