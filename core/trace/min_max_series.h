// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "support/types.h"

namespace syncline {

/// What one picture column of a series shows.
struct SeriesColumn {
  Nanoseconds start = 0;   // of the column; its width is the query's
  float min = 0, max = 0;  // exact over every sample in the column
  float last = 0;          // value of the latest sample in the column
  bool valid = false;      // false: no valid sample, draw a gap
  bool operator==(const SeriesColumn&) const = default;
};

/// Values over time with a min/max pyramid (factor 16), so that any window is reduced to columns in
/// time proportional to the columns, and a single outlier is never lost. A ring: the oldest samples go
/// when `capacity` is reached. Not thread-safe. NaN marks a gap.
class MinMaxSeries {
 public:
  /// `capacity` in samples; rounded up to a power of two, at least 8192. Memory grows with the samples
  /// up to it (12.6 bytes a sample).
  explicit MinMaxSeries(std::size_t capacity = 1U << 20);
  /// Of the same capacity and with the same times as `leader`, which are kept once (4.6 bytes a sample here): whatever
  /// is appended here was appended there just before, at the same time. Clear both or none. What the leader has already
  /// are gaps here.
  [[nodiscard]] static MinMaxSeries beside(const MinMaxSeries& leader);
  MinMaxSeries(MinMaxSeries&&) noexcept = default;
  MinMaxSeries& operator=(MinMaxSeries&&) noexcept = default;  // NOLINT(bugprone-reserved-identifier): clang's own

  /// `time` must not be earlier than the last one (such a sample is dropped).
  void append(Nanoseconds time, float value);
  /// As many one by one. None of the times is earlier than the one before, the first not than the last one here.
  void append(std::span<const Nanoseconds> times, std::span<const float> values);
  /// Room for so many, where their number is known: they are not moved while it grows.
  void reserve(std::size_t samples);
  void clear();
  /// Of a series that is complete: what is later than `time` is not there for those who read, until the next call;
  /// INT64_MAX: all is. Nothing may be appended while something is hidden.
  void show_until(Nanoseconds time);
  /// The first value later than `time`, also a hidden one; nothing behind the last.
  [[nodiscard]] std::optional<Nanoseconds> next_value(Nanoseconds time) const;

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  [[nodiscard]] bool empty() const { return end_ == begin_; }
  [[nodiscard]] Nanoseconds first_time() const;
  [[nodiscard]] Nanoseconds last_time() const;
  [[nodiscard]] std::size_t memory_bytes() const;
  [[nodiscard]] std::size_t capacity() const { return static_cast<std::size_t>(capacity_); }
  /// How far it is: what was asked of it before and lies between first_time() and the `last_time` of then is as it was
  /// while `filling` is the same.
  struct Stand {
    std::uint64_t filling = 0;  // of no other series, and another one when it is cleared
    std::uint64_t gone = 0;     // samples that went for newer ones
    Nanoseconds last_time = 0;
  };
  [[nodiscard]] Stand stand() const { return {filling_, begin_, last_time()}; }

  /// Columns of `width` ns that cover [begin, end). Their edges are multiples of `width` since the epoch
  /// whatever `begin` is, so a window that slides does not change the columns inside it.
  void columns(Nanoseconds begin, Nanoseconds end, Nanoseconds width, std::vector<SeriesColumn>& out) const;

  /// The same for a series whose value holds until the next one (a counter): the value before a column
  /// reaches into it, and a column without a sample shows the value that holds. After the last sample
  /// it holds until `hold_until`; columns that begin later are gaps, as are those after a NaN.
  void step_columns(Nanoseconds begin, Nanoseconds end, Nanoseconds width, Nanoseconds hold_until,
                    std::vector<SeriesColumn>& out) const;

  /// Samples in [begin, end), gaps included.
  [[nodiscard]] std::size_t count(Nanoseconds begin, Nanoseconds end) const;
  /// Exact smallest and largest valid value in [begin, end); nothing without one.
  struct Extent {
    float min = 0, max = 0;
  };
  [[nodiscard]] std::optional<Extent> extent(Nanoseconds begin, Nanoseconds end) const;

  /// Latest valid value at or before `time`, and its time: whoever shows it as present looks at its age.
  struct Reading {
    Nanoseconds time = 0;
    float value = 0;
  };
  [[nodiscard]] std::optional<Reading> at(Nanoseconds time) const;
  /// Of a series whose value holds until the next one: what holds at `time`; nothing after a gap.
  [[nodiscard]] std::optional<Reading> held_at(Nanoseconds time) const;
  /// Calls `visit(time, value)` for every sample in [begin, end), gaps (NaN) included.
  template <class Visit>
  void for_each(Nanoseconds begin, Nanoseconds end, Visit&& visit) const {
    for (auto i = lower_bound(begin); i < end_ && time_of(i) < end; ++i) visit(time_of(i), values_[slot(i)]);
  }

 private:
  struct Range {
    float min, max;  // min > max: nothing valid
  };
  static std::uint64_t next_filling();
  static constexpr std::uint64_t kFactor = 16;
  static constexpr std::size_t kLevels = 3;  // buckets of 16, 256 and 4096 samples

  [[nodiscard]] std::size_t slot(std::uint64_t index) const {
    return static_cast<std::size_t>(index & (capacity_ - 1));
  }
  [[nodiscard]] Nanoseconds time_of(std::uint64_t index) const { return (*times_)[slot(index)]; }
  [[nodiscard]] std::uint64_t lower_bound(Nanoseconds time) const;
  /// First sample at or after `time`, between these two (the second one may be it).
  [[nodiscard]] std::uint64_t bisect(std::uint64_t low, std::uint64_t high, Nanoseconds time) const;
  /// The same from `from` on, looked for from `guess` away.
  [[nodiscard]] std::uint64_t gallop(std::uint64_t from, std::uint64_t guess, Nanoseconds time) const;
  /// Asks for memory that is read soon.
  void fetch_time(std::uint64_t index) const;
  void fetch_edge(std::uint64_t index) const;
  [[nodiscard]] SeriesColumn column(Nanoseconds start, std::uint64_t first, std::uint64_t last) const;
  [[nodiscard]] Range range(std::uint64_t begin, std::uint64_t end) const;
  /// Sums up the buckets whose last sample lies at `place`; queries never use an incomplete one.
  void complete_buckets(std::size_t place);

  std::uint64_t capacity_;             // a power of two
  std::uint64_t begin_ = 0, end_ = 0;  // absolute indices of the samples that are kept
  std::uint64_t filling_ = next_filling();
  std::uint64_t hidden_ = 0;  // further ones behind the end
  std::shared_ptr<std::vector<Nanoseconds>> times_;
  bool leads_ = true;  // writes the times
  std::vector<float> values_;
  std::vector<Range> levels_[kLevels];
};

}  // namespace syncline
