// SPDX-License-Identifier: Apache-2.0
#include "support/confidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace syncline {
namespace {

/// The j-th slowest movement over n values that is no constant, of length 1.
double cosine(std::size_t j, std::size_t i, std::size_t n) {
  const auto count = static_cast<double>(n);
  return std::sqrt(2 / count) *
         std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(i) + 0.5) / count);
}

double mean_of(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// How much neighbours resemble each other, as it would be in kUsual values; 0 where they do not.
double likeness(std::span<const double> values, double mean) {
  constexpr double kUsual = 64;
  const auto n = static_cast<double>(values.size());
  double square = 0, with_next = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    square += (values[i] - mean) * (values[i] - mean);
    if (i > 0) with_next += (values[i] - mean) * (values[i - 1] - mean);
  }
  if (square <= 0) return 0;
  // The mean was taken from the same values, which makes neighbours look a little less alike.
  const double alike = with_next / square + 2 / n;
  return alike > 0 ? std::pow(std::min(alike, 1.0), n / kUsual) : 0;
}

/// Movements that are slow against how long values resemble each other; 0: hardly any is.
std::size_t slow_movements(double likeness) {
  if (likeness < 0.3) return 16;
  if (likeness < 0.55) return 8;
  return likeness < 0.85 ? 4 : 0;
}

/// Of a lopsided distribution the mean is; `value`: what Student's t would be of an even one.
double lopsided(double value, double skew) {
  constexpr double kEven = 1e-6;
  if (std::abs(skew) < kEven) return value;
  return (std::cbrt(1 + 6 * skew * (value - skew)) - 1) / (2 * skew);
}

/// Third moment of their mean, in its standard deviations, over six.
double skew_of(std::span<const double> values, double mean) {
  double square = 0, cube = 0;
  for (const double value : values) {
    const double rest = value - mean;
    square += rest * rest;
    cube += rest * rest * rest;
  }
  if (square <= 0) return 0;
  const auto n = static_cast<double>(values.size());
  return cube / n / std::pow(square / n, 1.5) / (6 * std::sqrt(n));
}

}  // namespace

double student_95(std::size_t freedom) {
  constexpr std::array kTable{12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060,
                              2.2622,  2.2281, 2.2010, 2.1788, 2.1604, 2.1448, 2.1314, 2.1199};
  if (freedom <= kTable.size()) return kTable[std::max<std::size_t>(freedom, 1) - 1];
  // Cornish and Fisher's expansion about the normal distribution: four digits from here on.
  constexpr double z = 1.959964;
  const auto n = static_cast<double>(freedom);
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n);
}

std::optional<Interval> mean_interval(std::span<const double> means) {
  const auto n = means.size();
  if (n < kFewestMeans) return std::nullopt;
  const double mean = mean_of(means);
  const auto movements = std::min(slow_movements(likeness(means, mean)), n / 3);
  if (movements == 0) return std::nullopt;
  double squares = 0;
  for (std::size_t j = 1; j <= movements; ++j) {
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) size += cosine(j, i, n) * (means[i] - mean);
    squares += size * size;
  }
  const double deviation = std::sqrt(squares / static_cast<double>(movements * n));
  if (!std::isfinite(deviation)) return std::nullopt;
  const double t = student_95(movements);
  const double skew = skew_of(means, mean);
  return Interval{-lopsided(t, skew) * deviation, -lopsided(-t, skew) * deviation};
}

std::optional<double> slope_half_width(std::span<const double> x, std::span<const double> y) {
  const auto n = std::min(x.size(), y.size());
  if (n < kFewestPoints || n > kMostPoints) return std::nullopt;
  const double x_mean = mean_of(x.first(n));
  const double y_mean = mean_of(y.first(n));
  double spread = 0, common = 0;
  for (std::size_t i = 0; i < n; ++i) {
    spread += (x[i] - x_mean) * (x[i] - x_mean);
    common += (x[i] - x_mean) * (y[i] - y_mean);
  }
  if (spread <= 0) return std::nullopt;
  const double slope = common / spread;
  std::array<double, kMostPoints> rest{};
  for (std::size_t i = 0; i < n; ++i) rest[i] = y[i] - y_mean - slope * (x[i] - x_mean);
  // The slowest movement looks like the line, which has taken it.
  constexpr std::size_t kFirst = 2, kMost = 6;
  const auto movements = std::min(kMost, n / 3);
  double squares = 0, left = 0;
  for (std::size_t j = kFirst; j < kFirst + movements; ++j) {
    double size = 0, along = 0;
    for (std::size_t i = 0; i < n; ++i) {
      size += cosine(j, i, n) * rest[i];
      along += cosine(j, i, n) * (x[i] - x_mean);
    }
    squares += size * size;
    left += 1 - along * along / spread;
  }
  if (left <= 0) return std::nullopt;
  return student_95(movements) * std::sqrt(squares / left / spread);
}

}  // namespace syncline
