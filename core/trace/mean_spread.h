// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace syncline {

struct Interval;

/// How sure the mean of a row of readings is, whose neighbours may resemble each other: kept are the sums of at most
/// kMost batches of as many readings each, however many there are. Fixed size, allocates nothing.
class MeanSpread {
 public:
  static constexpr std::size_t kMost = 128;

  void add(double value) {
    open_ += value;
    whole_ = whole_ && is_whole(value);
    if (++in_open_ == size_) close();
  }

  /// The 95 % interval of the mean, its ends as distances from it in the unit of the readings: of the mean that they
  /// would have if the machine went on as it does. `deviation`: their standard deviation. Readings that are all whole
  /// numbers have been rounded, and what rounding may have moved the mean by is in it. Nothing where they are too few
  /// (kFewestMeans) or vary too slowly for their number. Some 30 us.
  [[nodiscard]] std::optional<Interval> interval(double deviation) const;

 private:
  void close();
  [[nodiscard]] static bool is_whole(double value) {
    constexpr double kExact = 1LL << 53;
    return value < kExact && value > -kExact && value == static_cast<double>(static_cast<std::int64_t>(value));
  }

  std::array<double, kMost> sums_{};
  std::size_t batches_ = 0;
  std::uint64_t size_ = 1, in_open_ = 0;  // readings of a batch
  double open_ = 0;
  bool whole_ = true;
};

}  // namespace syncline
