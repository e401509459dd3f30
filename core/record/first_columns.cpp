// SPDX-License-Identifier: Apache-2.0
#include "record/first_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "record/column_codec.h"
#include "record/recording_reader.h"
#include "trace/signals.h"

namespace syncline {
namespace {

using Block = RecordingReader::Block;
using Range = RecordingReader::Range;

constexpr std::ptrdiff_t kNowhere = -1;
constexpr Nanoseconds kFar = std::numeric_limits<Nanoseconds>::max() / 4;  // no run lies beyond

Nanoseconds floor_div(Nanoseconds value, Nanoseconds by) { return value / by - (value % by < 0 ? 1 : 0); }

/// Cycles of a block that lie in one column, or in none that is drawn.
struct Part {
  std::size_t first = 0, last = 0;  // behind the last
  std::ptrdiff_t column = kNowhere;
};

/// A block that is damaged is a gap, as it will be when its samples are read.
Status left_out(Status status) {
  return !status && status.error().code == ErrorCode::kFileNotReadable ? Status{} : status;
}

/// Of cell `i` as it is drawn; empty where it has no value.
Range range_of(const ColumnCells& cells, std::size_t i) {
  float value = 0;
  if (!cells.floats.empty()) {
    value = cells.floats[i];
    if (std::isnan(value)) return {};
  } else {
    if (!cells.there.empty() && cells.there[i] == 0) return {};
    value = static_cast<float>(static_cast<double>(cells.integers[i]));
  }
  return {value, value};
}

class FirstColumns {
 public:
  FirstColumns(RecordingReader& reader, std::span<const Signal> signals, Nanoseconds begin, Nanoseconds end,
               Nanoseconds width)
      : reader_(reader), signals_(signals), width_(width), start_(floor_div(begin, width) * width) {
    const auto count = static_cast<std::size_t>(std::max<Nanoseconds>(floor_div(end - 1 - start_, width) + 1, 0));
    columns_.assign(signals.size(), std::vector<Range>(count));
  }

  /// In the order in which they were written: blocks within a column are done, the others wait.
  Status take(const Block& block);
  /// Blocks in which a column ends.
  Status split_rest();
  [[nodiscard]] std::vector<std::vector<SeriesColumn>> finish() const;

 private:
  struct Waiting {
    Block block;
    Nanoseconds newest = 0;  // before it: what is earlier is not drawn
    std::ptrdiff_t first = 0, last = 0;
    std::vector<Range> ranges;  // by signal
  };
  /// Of what is further away, wherever a damaged file says that it is, one beside those that are drawn.
  [[nodiscard]] std::ptrdiff_t column_at(Nanoseconds time) const {
    const auto count = static_cast<Nanoseconds>(columns_.front().size());
    return static_cast<std::ptrdiff_t>(
        floor_div(std::clamp(time, start_ - width_, start_ + count * width_) - start_, width_));
  }
  [[nodiscard]] bool is_drawn(std::ptrdiff_t column) const {
    return column >= 0 && static_cast<std::size_t>(column) < columns_.front().size();
  }
  /// It would change nothing, wherever in these columns it lies.
  [[nodiscard]] bool changes_nothing(std::size_t signal, const Range& range, std::ptrdiff_t first,
                                     std::ptrdiff_t last) const;
  void put(std::size_t signal, std::ptrdiff_t column, const Range& range) {
    if (is_drawn(column)) columns_[signal][static_cast<std::size_t>(column)].take(range);
  }
  Status split(const Waiting& waiting);
  Status find_parts(const Waiting& waiting);
  Status split(const Waiting& waiting, std::size_t signal);
  /// A bucket whose cycles lie in several columns: its cells are looked at where they may change one of them.
  Status split_bucket(const Waiting& waiting, std::size_t signal, std::size_t bucket, const Range& range,
                      std::span<const Part> parts, std::optional<ColumnCells>& cells);

  RecordingReader& reader_;
  std::span<const Signal> signals_;
  Nanoseconds width_, start_;
  std::vector<std::vector<Range>> columns_;  // by signal
  std::vector<Waiting> waiting_;
  std::optional<Nanoseconds> newest_;
  std::vector<Part> parts_;  // of the block that is split
  std::vector<Range> buckets_;
  ColumnCells times_;
};

bool FirstColumns::changes_nothing(std::size_t signal, const Range& range, std::ptrdiff_t first,
                                   std::ptrdiff_t last) const {
  if (range.empty()) return true;
  for (auto column = first; column <= last; ++column) {
    if (is_drawn(column) && !columns_[signal][static_cast<std::size_t>(column)].holds(range)) return false;
  }
  return true;
}

Status FirstColumns::take(const Block& block) {
  const auto first = column_at(block.begin);
  const auto last = column_at(block.end);
  const auto newest = newest_.value_or(block.begin);
  newest_ = std::max(newest, block.end);
  if (last < 0 || first >= static_cast<std::ptrdiff_t>(columns_.front().size())) return {};
  // What will be a gap when its samples are read is none of the picture either.
  const auto whole = reader_.is_whole(block);
  if (!whole) return left_out(tl::unexpected(whole.error()));
  if (!*whole) return {};
  std::vector<Range> ranges(signals_.size());
  if (auto status = reader_.ranges(block, signals_, ranges); !status) return left_out(status);
  if (first != last || block.begin < newest) {
    waiting_.push_back({block, newest, first, last, std::move(ranges)});
    return {};
  }
  for (std::size_t signal = 0; signal < signals_.size(); ++signal) put(signal, first, ranges[signal]);
  return {};
}

Status FirstColumns::split_rest() {
  for (const auto& waiting : waiting_) {
    if (auto status = left_out(split(waiting)); !status) return status;
  }
  return {};
}

Status FirstColumns::split(const Waiting& waiting) {
  parts_.clear();
  for (std::size_t signal = 0; signal < signals_.size(); ++signal) {
    if (changes_nothing(signal, waiting.ranges[signal], waiting.first, waiting.last)) continue;
    if (parts_.empty()) {
      if (auto status = find_parts(waiting); !status) return status;
    }
    if (auto status = split(waiting, signal); !status) return status;
  }
  return {};
}

Status FirstColumns::find_parts(const Waiting& waiting) {
  if (auto status = reader_.cells(waiting.block, Signal::kSendTime, times_); !status) return status;
  const auto& times = times_.integers;
  auto newest = waiting.newest;
  Nanoseconds from = 0;  // of the column of the part before
  Nanoseconds to = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto time = times[i];
    const bool hidden = time < newest;
    newest = std::max(newest, time);
    const bool same = !parts_.empty() && !hidden && time >= from && time < to;
    if (!same) {
      const auto column = column_at(time);
      parts_.push_back({i, i, hidden ? kNowhere : column});
      from = start_ + static_cast<Nanoseconds>(column) * width_;
      to = hidden ? from : from + width_;
    }
    parts_.back().last = i + 1;
  }
  return {};
}

Status FirstColumns::split(const Waiting& waiting, std::size_t signal) {
  if (auto status = reader_.ranges(waiting.block, signals_[signal], buckets_); !status) return status;
  std::optional<ColumnCells> cells;
  std::size_t part = 0;
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    const auto& range = buckets_[bucket];
    const auto begin = bucket * kLevelCycles;
    const auto end = begin + kLevelCycles;
    while (part < parts_.size() && parts_[part].last <= begin) ++part;
    auto behind = part;
    while (behind < parts_.size() && parts_[behind].first < end) ++behind;
    if (range.empty()) continue;
    const auto parts = std::span(parts_).subspan(part, behind - part);
    if (parts.size() == 1) {
      put(signal, parts.front().column, range);
    } else if (auto status = split_bucket(waiting, signal, bucket, range, parts, cells); !status) {
      return status;
    }
  }
  return {};
}

Status FirstColumns::split_bucket(const Waiting& waiting, std::size_t signal, std::size_t bucket, const Range& range,
                                  std::span<const Part> parts, std::optional<ColumnCells>& cells) {
  const auto idle = [&](const Part& part) { return changes_nothing(signal, range, part.column, part.column); };
  if (std::ranges::all_of(parts, idle)) return {};
  if (!cells) {
    if (auto status = reader_.cells(waiting.block, signals_[signal], cells.emplace()); !status) return status;
  }
  const auto begin = bucket * kLevelCycles;
  for (const auto& part : parts) {
    Range found;
    for (auto i = std::max(part.first, begin); i < std::min(part.last, begin + kLevelCycles); ++i)
      found.take(range_of(*cells, i));
    put(signal, part.column, found);
  }
  return {};
}

std::vector<std::vector<SeriesColumn>> FirstColumns::finish() const {
  std::vector<std::vector<SeriesColumn>> drawn;
  for (const auto& ranges : columns_) {
    auto& columns = drawn.emplace_back();
    columns.reserve(ranges.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      auto& column = columns.emplace_back();
      column.start = start_ + static_cast<Nanoseconds>(i) * width_;
      column.valid = !ranges[i].empty();
      column.last = std::numeric_limits<float>::quiet_NaN();
      if (!column.valid) continue;
      column.min = ranges[i].min;
      column.max = ranges[i].max;
    }
  }
  return drawn;
}

}  // namespace

Result<std::vector<std::vector<SeriesColumn>>> first_columns(RecordingReader& reader, std::span<const Signal> signals,
                                                             Nanoseconds begin, Nanoseconds end, Nanoseconds width,
                                                             const std::set<std::size_t>& gaps) {
  const bool somewhere = begin >= -kFar && end <= kFar && width > 0 && width <= kFar;
  if (signals.empty() || !somewhere || end <= begin) return std::vector<std::vector<SeriesColumn>>(signals.size());
  const auto held = reader.hold();
  if (!held) return tl::unexpected(held.error());
  const auto blocks = reader.blocks();
  if (!blocks) return tl::unexpected(blocks.error());
  FirstColumns columns(reader, signals, begin, end, width);
  Status status;
  for (std::size_t i = 0; status && i < blocks->size(); ++i) {
    if (!gaps.contains(i)) status = columns.take((*blocks)[i]);
  }
  if (status) status = columns.split_rest();
  if (!status) return tl::unexpected(status.error());
  return columns.finish();
}

}  // namespace syncline
