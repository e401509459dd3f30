// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "support/types.h"

namespace syncline::trace {

/// Cell without a value (frame lost, register not read in this cycle).
inline constexpr std::int32_t kNoValue = std::numeric_limits<std::int32_t>::min();

struct MinMax {
  std::int32_t min = std::numeric_limits<std::int32_t>::max();
  std::int32_t max = std::numeric_limits<std::int32_t>::min();
  bool operator==(const MinMax&) const = default;
  [[nodiscard]] bool empty() const { return min > max; }
  void add(std::int32_t value) {
    if (value == kNoValue) return;
    if (value < min) min = value;
    if (value > max) max = value;
  }
  void add(const MinMax& other) {
    if (other.min < min) min = other.min;
    if (other.max > max) max = other.max;
  }
};

/// Append-only table of rows (time, one int32 a column) with a min/max pyramid over the rows: a node
/// of level n covers 16^n rows that begin at a multiple of 16^n. Rows live in blocks of 4096; when
/// the capacity is used up the oldest block goes. Not thread-safe: one thread fills and asks.
class SampleTable {
 public:
  static constexpr std::size_t kFactor = 16;
  static constexpr std::size_t kBlockRows = 4096;
  static constexpr std::size_t kLevels = 3;

  /// At most `capacity` rows are kept (rounded up to whole blocks, at least one).
  explicit SampleTable(std::size_t columns, std::size_t capacity);

  /// One value a column. Times must rise: a row that is not later than the last is refused (false).
  bool append(Nanoseconds time, std::span<const std::int32_t> values);
  void clear();

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] Nanoseconds time(std::size_t row) const;   // row < rows(), 0 = oldest kept
  [[nodiscard]] std::int32_t value(std::size_t column, std::size_t row) const;
  /// First row at or after `time`, rows() when there is none.
  [[nodiscard]] std::size_t row_at(Nanoseconds time) const;
  /// Smallest and largest value of the rows [first, last); exact.
  [[nodiscard]] MinMax min_max(std::size_t column, std::size_t first, std::size_t last) const;
  /// Last row before `row` that has a value in `column`.
  [[nodiscard]] std::optional<std::size_t> value_before(std::size_t column, std::size_t row) const;

 private:
  struct Column {
    std::vector<std::int32_t> values;
    std::array<std::vector<MinMax>, kLevels> levels;  // complete nodes only
  };
  struct Block {
    std::vector<Nanoseconds> times;
    std::vector<Column> columns;
  };

  [[nodiscard]] const Block& block_of(std::size_t row) const { return *blocks_[row / kBlockRows]; }
  void begin_block();
  static void complete_nodes(Column& column);
  static void add_range(const Column& column, std::size_t first, std::size_t last, MinMax& result);

  std::size_t columns_;
  std::size_t max_blocks_;
  std::size_t rows_ = 0;
  std::deque<std::unique_ptr<Block>> blocks_;
};

}  // namespace syncline::trace
