// SPDX-License-Identifier: Apache-2.0
#include "trace/min_max_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace syncline {
namespace {

constexpr float kHuge = std::numeric_limits<float>::infinity();
constexpr std::uint64_t kTop = 4096;

constexpr std::uint64_t round_up(std::uint64_t value, std::uint64_t step) { return (value + step - 1) / step * step; }

/// Largest multiple of `width` that is not above `time`.
Nanoseconds floor_to(Nanoseconds time, Nanoseconds width) {
  const auto rest = time % width;
  return time - (rest < 0 ? rest + width : rest);
}

}  // namespace

MinMaxSeries::MinMaxSeries(std::size_t capacity)
    : capacity_(std::max<std::uint64_t>(round_up(capacity, kTop), 2 * kTop)), times_(capacity_), values_(capacity_) {
  std::uint64_t bucket = 1;
  for (auto& level : levels_) {
    bucket *= kFactor;
    level.assign(capacity_ / bucket, Range{kHuge, -kHuge});
  }
}

void MinMaxSeries::clear() { begin_ = end_ = 0; }

Nanoseconds MinMaxSeries::first_time() const { return empty() ? 0 : times_[slot(begin_)]; }
Nanoseconds MinMaxSeries::last_time() const { return empty() ? 0 : times_[slot(end_ - 1)]; }

std::size_t MinMaxSeries::memory_bytes() const {
  std::size_t bytes = times_.capacity() * sizeof(Nanoseconds) + values_.capacity() * sizeof(float);
  for (const auto& level : levels_) bytes += level.capacity() * sizeof(Range);
  return bytes;
}

void MinMaxSeries::append(Nanoseconds time, float value) {
  if (!empty() && time < last_time()) return;
  // Buckets are reused as a whole: the oldest block of the top level goes at once.
  if (end_ - begin_ == capacity_) begin_ += kTop;
  times_[slot(end_)] = time;
  values_[slot(end_)] = value;
  merge_into_levels(end_, value);
  ++end_;
}

void MinMaxSeries::merge_into_levels(std::uint64_t index, float value) {
  std::uint64_t bucket = 1;
  for (auto& level : levels_) {
    bucket *= kFactor;
    auto& entry = level[slot(index) / bucket];
    if (index % bucket == 0) entry = Range{kHuge, -kHuge};
    if (!std::isnan(value)) {
      entry.min = std::min(entry.min, value);
      entry.max = std::max(entry.max, value);
    }
  }
}

std::uint64_t MinMaxSeries::lower_bound(Nanoseconds time) const {
  std::uint64_t low = begin_;
  std::uint64_t high = end_;
  while (low < high) {
    const auto middle = low + (high - low) / 2;
    if (times_[slot(middle)] < time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

MinMaxSeries::Range MinMaxSeries::range(std::uint64_t begin, std::uint64_t end) const {
  Range result{kHuge, -kHuge};
  const auto take = [&result](float low, float high) {
    result.min = std::min(result.min, low);
    result.max = std::max(result.max, high);
  };
  while (begin < end) {
    // The largest bucket that starts here and ends inside.
    std::uint64_t bucket = 1;
    std::size_t level = 0;
    while (level < kLevels && begin % (bucket * kFactor) == 0 && begin + bucket * kFactor <= end) {
      bucket *= kFactor;
      ++level;
    }
    if (level == 0) {
      const float value = values_[slot(begin)];
      if (!std::isnan(value)) take(value, value);
    } else {
      const auto& entry = levels_[level - 1][slot(begin) / bucket];
      take(entry.min, entry.max);
    }
    begin += bucket;
  }
  return result;
}

void MinMaxSeries::columns(Nanoseconds begin, Nanoseconds end, Nanoseconds width,
                           std::vector<SeriesColumn>& out) const {
  out.clear();
  if (width <= 0 || end <= begin) return;
  auto start = floor_to(begin, width);
  auto index = lower_bound(start);
  for (; start < end; start += width) {
    SeriesColumn column;
    column.start = start;
    const auto first = index;
    // Neighbouring columns hold few samples or many: galloping beats a binary search over everything.
    std::uint64_t step = 1;
    while (index + step < end_ && times_[slot(index + step)] < start + width) step *= 2;
    auto low = index;
    auto high = std::min(index + step, end_);
    while (low < high) {
      const auto middle = low + (high - low) / 2;
      if (times_[slot(middle)] < start + width) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    index = low;
    if (index > first) {
      const auto found = range(first, index);
      column.valid = found.min <= found.max;
      if (column.valid) {
        column.min = found.min;
        column.max = found.max;
        auto last = index - 1;
        while (std::isnan(values_[slot(last)])) --last;
        column.last = values_[slot(last)];
      }
    }
    out.push_back(column);
  }
}

std::optional<MinMaxSeries::Reading> MinMaxSeries::at(Nanoseconds time) const {
  auto index = lower_bound(time + 1);
  while (index > begin_) {
    --index;
    if (!std::isnan(values_[slot(index)])) return Reading{times_[slot(index)], values_[slot(index)]};
  }
  return std::nullopt;
}

}  // namespace syncline
