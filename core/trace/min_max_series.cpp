// SPDX-License-Identifier: Apache-2.0
#include "trace/min_max_series.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

#include "support/floor_to.h"
#include "support/large_pages.h"

namespace syncline {
namespace {

constexpr float kHuge = std::numeric_limits<float>::infinity();
constexpr std::uint64_t kTop = 4096;

/// For so many more; it grows by as much as it has, so that what is there is seldom moved.
template <class T>
void grow(std::vector<T>& ring, std::size_t more) {
  if (ring.capacity() - ring.size() < more)
    reserve_in_large_pages(ring, std::max(ring.size() + more, 2 * ring.capacity()));
}

/// Overwrites the slot, or grows the ring by it as long as it is not full for the first time.
template <class T>
void put(std::vector<T>& ring, std::size_t slot, T value) {
  if (slot < ring.size()) {
    ring[slot] = value;
  } else {
    grow(ring, 1);
    ring.push_back(value);
  }
}

template <class T>
void put(std::vector<T>& ring, std::size_t slot, std::span<const T> values) {
  const auto known = std::min(values.size(), ring.size() - slot);
  std::copy_n(values.begin(), known, ring.begin() + static_cast<std::ptrdiff_t>(slot));
  if (known == values.size()) return;
  grow(ring, values.size() - known);
  ring.insert(ring.end(), values.begin() + static_cast<std::ptrdiff_t>(known), values.end());
}

}  // namespace

std::uint64_t MinMaxSeries::next_filling() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

MinMaxSeries::MinMaxSeries(std::size_t capacity)
    : capacity_(std::bit_ceil(std::max<std::uint64_t>(capacity, 2 * kTop))),
      times_(std::make_shared<std::vector<Nanoseconds>>()) {}

MinMaxSeries MinMaxSeries::beside(const MinMaxSeries& leader) {
  MinMaxSeries series(leader.capacity_);
  series.times_ = leader.times_;
  series.leads_ = false;
  series.begin_ = leader.begin_;
  series.end_ = leader.end_;
  series.values_.assign(leader.values_.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t level = 0; level < kLevels; ++level)
    series.levels_[level].assign(leader.levels_[level].size(), Range{kHuge, -kHuge});
  return series;
}

void MinMaxSeries::clear() {
  begin_ = end_ = hidden_ = 0;
  filling_ = next_filling();
}

/// Buckets need no change: those that reach beyond the end are incomplete to whoever asks.
void MinMaxSeries::show_until(Nanoseconds time) {
  const auto all = end_ + hidden_;
  end_ = time == INT64_MAX ? all : bisect(begin_, all, time + 1);
  hidden_ = all - end_;
}

std::optional<Nanoseconds> MinMaxSeries::next_value(Nanoseconds time) const {
  const auto all = end_ + hidden_;
  for (auto i = bisect(begin_, all, time == INT64_MAX ? time : time + 1); i < all; ++i) {
    if (!std::isnan(values_[slot(i)])) return time_of(i);
  }
  return std::nullopt;
}

Nanoseconds MinMaxSeries::first_time() const { return empty() ? 0 : time_of(begin_); }
Nanoseconds MinMaxSeries::last_time() const { return empty() ? 0 : time_of(end_ - 1); }

std::size_t MinMaxSeries::memory_bytes() const {
  std::size_t bytes = values_.capacity() * sizeof(float);
  if (leads_) bytes += times_->capacity() * sizeof(Nanoseconds);
  for (const auto& level : levels_) bytes += level.capacity() * sizeof(Range);
  return bytes;
}

void MinMaxSeries::append(Nanoseconds time, float value) {
  if (!empty() && time < last_time()) return;
  // Buckets are reused as a whole: the oldest block of the top level goes at once.
  if (end_ - begin_ == capacity_) begin_ += kTop;
  const auto place = slot(end_);
  if (leads_) put(*times_, place, time);
  put(values_, place, value);
  if ((place + 1) % kFactor == 0) complete_buckets(place);
  ++end_;
}

void MinMaxSeries::append(std::span<const Nanoseconds> times, std::span<const float> values) {
  while (!values.empty()) {
    if (end_ - begin_ == capacity_) begin_ += kTop;
    const auto place = slot(end_);
    // To the end of a block of the top level: neither the ring nor what is free ends within one.
    const auto count = std::min(values.size(), static_cast<std::size_t>(kTop - place % kTop));
    if (leads_) put(*times_, place, times.first(count));
    put(values_, place, values.first(count));
    for (auto last = place | (kFactor - 1); last < place + count; last += kFactor) complete_buckets(last);
    end_ += count;
    times = times.subspan(count);
    values = values.subspan(count);
  }
}

void MinMaxSeries::reserve(std::size_t samples) {
  samples = std::min(samples, static_cast<std::size_t>(capacity_));
  if (leads_) reserve_in_large_pages(*times_, samples);
  reserve_in_large_pages(values_, samples);
  for (auto& level : levels_) reserve_in_large_pages(level, samples /= kFactor);
}

void MinMaxSeries::complete_buckets(std::size_t place) {
  Range range{kHuge, -kHuge};
  for (auto i = place + 1 - kFactor; i <= place; ++i) {
    // Comparisons with NaN are false, so a gap changes nothing.
    if (values_[i] < range.min) range.min = values_[i];
    if (values_[i] > range.max) range.max = values_[i];
  }
  put(levels_[0], place / kFactor, range);
  std::size_t bucket = kFactor;
  for (std::size_t level = 1; level < kLevels && (place + 1) % (bucket * kFactor) == 0; ++level) {
    const auto& below = levels_[level - 1];
    Range parent{kHuge, -kHuge};
    const auto last = place / bucket;
    for (auto i = last + 1 - kFactor; i <= last; ++i) {
      parent.min = std::min(parent.min, below[i].min);
      parent.max = std::max(parent.max, below[i].max);
    }
    bucket *= kFactor;
    put(levels_[level], place / bucket, parent);
  }
}

std::uint64_t MinMaxSeries::bisect(std::uint64_t low, std::uint64_t high, Nanoseconds time) const {
  while (low < high) {
    const auto middle = low + (high - low) / 2;
    if (time_of(middle) < time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

std::uint64_t MinMaxSeries::lower_bound(Nanoseconds time) const { return bisect(begin_, end_, time); }

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

std::uint64_t MinMaxSeries::gallop(std::uint64_t from, std::uint64_t guess, Nanoseconds time) const {
  // Columns hold about as many samples as their neighbour: away from where that ends, in steps that grow, a search
  // stays in memory that is near, where one over everything does not.
  guess = std::clamp(guess, from, end_);
  std::uint64_t step = 1;
  if (guess < end_ && time_of(guess) < time) {
    auto low = guess + 1;
    while (low + step < end_ && time_of(low + step) < time) {
      low += step + 1;
      step *= 2;
    }
    return bisect(low, std::min(low + step, end_), time);
  }
  auto high = guess;
  while (high - from > step && time_of(high - step) >= time) {
    high -= step;
    step *= 2;
  }
  return bisect(high - std::min(step, high - from), high, time);
}

SeriesColumn MinMaxSeries::column(Nanoseconds start, std::uint64_t first, std::uint64_t last) const {
  SeriesColumn column;
  column.start = start;
  const auto found = range(first, last);
  column.valid = found.min <= found.max;
  if (!column.valid) return column;
  column.min = found.min;
  column.max = found.max;
  while (std::isnan(values_[slot(last - 1)])) --last;
  column.last = values_[slot(last - 1)];
  return column;
}

void MinMaxSeries::fetch_time(std::uint64_t index) const {
  if (index < end_) __builtin_prefetch(&(*times_)[slot(index)]);
}

void MinMaxSeries::fetch_edge(std::uint64_t index) const {
  if (index >= end_) return;
  const auto place = slot(index);
  __builtin_prefetch(&values_[place]);
  std::uint64_t bucket = 1;
  for (const auto& level : levels_) {
    bucket *= kFactor;
    if (place / bucket < level.size()) __builtin_prefetch(&level[place / bucket]);
  }
}

void MinMaxSeries::columns(Nanoseconds begin, Nanoseconds end, Nanoseconds width,
                           std::vector<SeriesColumn>& out) const {
  out.clear();
  if (width <= 0 || end <= begin) return;
  const auto first_start = floor_to(begin, width);
  // Of a long series every edge lies in memory of its own, on each level: it is asked for some columns ahead.
  constexpr std::size_t kAhead = 8;
  std::vector<std::uint64_t> edges{lower_bound(first_start)};
  std::uint64_t count = 1;
  for (auto start = first_start; start < end; start += width) {
    const auto first = edges.back();
    edges.push_back(gallop(first, first + count, start + width));
    count = edges.back() - first;
    fetch_time(edges.back() + kAhead * count);
  }
  out.reserve(edges.size() - 1);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (i + kAhead < edges.size()) fetch_edge(edges[i + kAhead]);
    out.push_back(column(first_start + static_cast<Nanoseconds>(i) * width, edges[i], edges[i + 1]));
  }
}

void MinMaxSeries::step_columns(Nanoseconds begin, Nanoseconds end, Nanoseconds width, Nanoseconds hold_until,
                                std::vector<SeriesColumn>& out) const {
  out.clear();
  if (width <= 0 || end <= begin) return;
  auto start = floor_to(begin, width);
  auto first = lower_bound(start);
  std::uint64_t count = 1;
  for (; start < end; start += width) {
    const auto last = gallop(first, first + count, start + width);
    count = last - first;
    auto step = column(start, first, last);
    const bool held = first > begin_ && (first < end_ || start <= hold_until);
    const float before = held ? values_[slot(first - 1)] : std::numeric_limits<float>::quiet_NaN();
    if (!std::isnan(before)) {
      step.min = step.valid ? std::min(step.min, before) : before;
      step.max = step.valid ? std::max(step.max, before) : before;
      if (!step.valid) step.last = before;
      step.valid = true;
    }
    out.push_back(step);
    first = last;
  }
}

std::size_t MinMaxSeries::count(Nanoseconds begin, Nanoseconds end) const {
  return end <= begin ? 0 : static_cast<std::size_t>(lower_bound(end) - lower_bound(begin));
}

std::optional<MinMaxSeries::Extent> MinMaxSeries::extent(Nanoseconds begin, Nanoseconds end) const {
  if (end <= begin) return std::nullopt;
  const auto found = range(lower_bound(begin), lower_bound(end));
  if (found.min > found.max) return std::nullopt;
  return Extent{found.min, found.max};
}

std::optional<MinMaxSeries::Reading> MinMaxSeries::held_at(Nanoseconds time) const {
  const auto index = lower_bound(time + 1);
  if (index == begin_ || std::isnan(values_[slot(index - 1)])) return std::nullopt;
  return Reading{time_of(index - 1), values_[slot(index - 1)]};
}

std::optional<MinMaxSeries::Reading> MinMaxSeries::at(Nanoseconds time) const {
  auto index = lower_bound(time + 1);
  while (index > begin_) {
    // Long gaps are left out a bucket at a time.
    std::uint64_t bucket = kTop;
    std::size_t level = kLevels;
    const auto is_gap = [&] {
      if (index % bucket != 0 || index - begin_ < bucket) return false;
      const auto& range = levels_[level - 1][slot(index - bucket) / bucket];
      return range.min > range.max;
    };
    while (level > 0 && !is_gap()) {
      bucket /= kFactor;
      --level;
    }
    if (level > 0) {
      index -= bucket;
      continue;
    }
    --index;
    if (!std::isnan(values_[slot(index)])) return Reading{time_of(index), values_[slot(index)]};
  }
  return std::nullopt;
}

}  // namespace syncline
