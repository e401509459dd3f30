// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "trace/min_max_series.h"

namespace syncline {

/// Equal bins over [low, high), an edge belongs to the bin above it; what lies outside is counted, too.
struct BinGrid {
  double low = 0, high = 1;
  std::size_t bins = 64;
  bool operator==(const BinGrid&) const = default;

  [[nodiscard]] double width() const { return (high - low) / static_cast<double>(bins); }
};

/// How often which value came in a stretch of a series: every sample of it counts, none that is drawn. The stretch may
/// move: what comes in is added, what goes out is taken away. Works in portions, so that whoever has little time for it
/// can count 10 million samples, too. Lives in the thread of its series.
class Distribution {
 public:
  Distribution();

  /// What is to be counted from now on. Keeps what it has of the stretch; begins anew with another series or grid, or
  /// where samples that were counted have gone from the series. Null: nothing.
  void aim(const MinMaxSeries* series, Nanoseconds begin, Nanoseconds end, const BinGrid& grid);
  /// Counts about `samples` more; true when all of the stretch is counted.
  bool work(std::size_t samples);
  [[nodiscard]] bool complete() const { return series_ == nullptr || (begin_ == want_begin_ && end_ == want_end_); }
  /// Part of the stretch that is counted, 0..1.
  [[nodiscard]] double progress() const;

  [[nodiscard]] const BinGrid& grid() const { return grid_; }
  [[nodiscard]] std::span<const std::uint64_t> bins() const { return bins_; }
  [[nodiscard]] std::uint64_t below() const { return below_; }
  [[nodiscard]] std::uint64_t above() const { return above_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Value that `fraction` (0..1] of the samples do not exceed: never too small, and too large by 1/512 of it at most.
  /// Nothing without a sample.
  [[nodiscard]] std::optional<double> quantile(double fraction) const;
  /// Exact.
  [[nodiscard]] std::optional<MinMaxSeries::Extent> extent() const;

  struct Hit {
    Nanoseconds time = 0;
    float value = 0;
  };
  /// The latest `most` samples of a bin (-1: below, bins().size(): above), by time.
  [[nodiscard]] std::vector<Hit> hits(std::ptrdiff_t bin, std::size_t most) const;

 private:
  void begin_anew();
  void take(Nanoseconds begin, Nanoseconds end, bool add);

  const MinMaxSeries* series_ = nullptr;
  BinGrid grid_;
  Nanoseconds begin_ = 0, end_ = 0;            // counted
  Nanoseconds want_begin_ = 0, want_end_ = 0;  // to be counted
  std::vector<std::uint64_t> bins_;
  std::vector<std::uint32_t> fine_;  // by the upper bits of a value, in their order
  std::uint64_t below_ = 0, above_ = 0, count_ = 0;
};

}  // namespace syncline
