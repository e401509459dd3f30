// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace syncline {

/// Histogram of magnitudes in ns with bins whose width grows with the value (at most 1/32 of it), so
/// that nanoseconds and milliseconds fit one table. Minimum and maximum are exact, percentiles are the
/// upper edge of their bin but never above the maximum.
class Histogram {
 public:
  Histogram();
  void add(std::int64_t value);  // negative values count as 0
  void clear();
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::int64_t min() const { return min_; }
  [[nodiscard]] std::int64_t max() const { return max_; }
  /// Value that `fraction` (0..1] of the samples do not exceed; 0 without samples.
  [[nodiscard]] std::int64_t percentile(double fraction) const;

  struct Bin {
    std::int64_t low = 0, high = 0;  // [low, high)
    std::uint64_t count = 0;
  };
  [[nodiscard]] std::vector<Bin> bins() const;  // the used ones, ascending

 private:
  std::vector<std::uint64_t> counts_;
  std::uint64_t count_ = 0;
  std::int64_t min_ = 0, max_ = 0;
};

}  // namespace syncline
