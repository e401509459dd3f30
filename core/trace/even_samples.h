// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "support/types.h"

namespace syncline {

class MinMaxSeries;

/// Samples of a signal at equal distances, as stretches between its gaps. Nothing is filled in: what lies about a gap
/// stands in stretches of its own, and how much was left out is counted.
class EvenSamples {
 public:
  /// A gap begins where the next sample comes later than this many sampling intervals.
  static constexpr double kLate = 1.8;

  /// How much of an interval a distance may be off before it is told.
  static constexpr double kUneven = 0.1;

  /// Copies [begin, end) of the series; `longest` ns: neighbours further apart have a gap between them in any case.
  EvenSamples() = default;
  EvenSamples(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end, Nanoseconds longest);

  /// It may be moved, which leaves its stretches where they are, but not copied.
  EvenSamples(EvenSamples&&) noexcept = default;
  EvenSamples& operator=(EvenSamples&&) noexcept = default;

  /// The same in parts, for whoever has no time for all at once.
  void add(Nanoseconds time, float value);
  /// Finds the stretches; `longest` as above.
  void finish(Nanoseconds longest);
  void reserve(std::size_t count);

  /// Sampling interval in ns; 0 with fewer than two samples.
  [[nodiscard]] double interval() const { return interval_; }
  /// At least kShortest samples each, by time.
  static constexpr std::size_t kShortest = 8;
  [[nodiscard]] const std::vector<std::span<const float>>& stretches() const { return stretches_; }
  /// Of the samples that were given, without the gaps, and in the stretches.
  [[nodiscard]] std::size_t given() const { return given_; }
  [[nodiscard]] std::size_t used() const { return used_; }
  /// Neighbours in the stretches whose distance is off the usual one by more than a tenth: they count as one interval.
  [[nodiscard]] std::size_t uneven() const { return uneven_; }
  /// Gaps between the stretches that count.
  [[nodiscard]] std::size_t gaps() const { return stretches_.empty() ? 0 : stretches_.size() - 1; }

 private:
  std::vector<Nanoseconds> times_;
  std::vector<float> values_;
  std::vector<std::span<const float>> stretches_;
  double interval_ = 0;
  std::size_t given_ = 0, used_ = 0, uneven_ = 0;
};

}  // namespace syncline
