// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "support/confidence.h"
#include "trace/mean_spread.h"

namespace syncline {

/// Running count, mean, root mean square, minimum, maximum. Mean and square are updated in Welford's
/// way, so that hours of samples lose no digits.
class Statistics {
 public:
  void add(double value) {
    ++count_;
    const double delta = value - mean_;
    mean_ += delta / static_cast<double>(count_);
    squared_deviation_ += delta * (value - mean_);
    min_ = count_ == 1 ? value : std::min(min_, value);
    max_ = count_ == 1 ? value : std::max(max_, value);
    spread_.add(value);
  }
  void clear() { *this = Statistics{}; }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const { return mean_; }
  /// 95 % interval of the mean (mean_spread.h); nothing where the values are too few, or vary too slowly, to tell.
  [[nodiscard]] std::optional<Interval> mean_interval() const {
    const auto about = spread_.interval(standard_deviation());
    if (!about) return std::nullopt;
    return Interval{mean_ + about->low, mean_ + about->high};
  }
  /// How far the interval reaches to its further side: what stands behind "±".
  [[nodiscard]] std::optional<double> mean_half_width() const {
    const auto about = spread_.interval(standard_deviation());
    return about ? std::optional(std::max(-about->low, about->high)) : std::nullopt;
  }
  [[nodiscard]] double standard_deviation() const {
    return count_ == 0 ? 0 : std::sqrt(squared_deviation_ / static_cast<double>(count_));
  }
  /// About zero, not about the mean.
  [[nodiscard]] double rms() const {
    return count_ == 0 ? 0 : std::sqrt(mean_ * mean_ + squared_deviation_ / static_cast<double>(count_));
  }
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return max_; }
  [[nodiscard]] double max_magnitude() const { return std::max(std::abs(min_), std::abs(max_)); }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0, squared_deviation_ = 0, min_ = 0, max_ = 0;
  MeanSpread spread_;
};

}  // namespace syncline
