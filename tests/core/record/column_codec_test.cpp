// SPDX-License-Identifier: Apache-2.0
#include "record/column_codec.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace syncline {
namespace {

Cells integers(const std::vector<std::optional<std::int64_t>>& values) {
  Cells cells;
  for (const auto& value : values) cells.push_back(value ? std::optional<SignalNumber>(*value) : std::nullopt);
  return cells;
}

std::size_t size_of(const ColumnCells& cells) { return std::max(cells.integers.size(), cells.floats.size()); }

Cells cells_of(const ColumnCells& column) {
  Cells cells(size_of(column));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!column.floats.empty()) {
      if (!std::isnan(column.floats[i])) cells[i] = column.floats[i];
    } else if (column.there.empty() || column.there[i] != 0) {
      cells[i] = column.integers[i];
    }
  }
  return cells;
}

Cells back(const Cells& cells) {
  const auto column = encode_column(cells);
  ColumnCells read;
  if (!column) return Cells(cells.size());
  EXPECT_TRUE(decode_column(column->codec, column->bytes, cells.size(), read));
  return cells_of(read);
}

TEST(ColumnCodec, AnyIntegersComeBack) {
  EXPECT_TRUE(rc::check([](const std::vector<std::int64_t>& values, const std::vector<bool>& there) {
    Cells cells;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool valid = i >= there.size() || there[i];
      cells.push_back(valid ? std::optional<SignalNumber>(values[i]) : std::nullopt);
    }
    if (!cells.empty()) RC_ASSERT(back(cells) == cells);
  }));
}

TEST(ColumnCodec, TheLargestDifferencesComeBack) {
  constexpr auto kLeast = std::numeric_limits<std::int64_t>::min(), kMost = std::numeric_limits<std::int64_t>::max();
  for (const auto& cells : {integers({kLeast, kMost, kLeast, 0}), integers({kMost}), integers({kLeast, std::nullopt}),
                            integers({0, kMost, -2}), integers({std::nullopt, std::nullopt})}) {
    EXPECT_EQ(back(cells), cells);
  }
}

TEST(ColumnCodec, AnyFloatsComeBack) {
  EXPECT_TRUE(rc::check([](const std::vector<std::int32_t>& values) {
    Cells cells;
    for (const auto value : values)
      cells.push_back(value % 5 == 0 ? std::nullopt : std::optional<SignalNumber>(static_cast<float>(value) / 3));
    if (!cells.empty()) RC_ASSERT(back(cells) == cells);
  }));
}

TEST(ColumnCodec, WhatRisesAlikeTakesAFewBytes) {
  std::vector<std::optional<std::int64_t>> cycles;
  for (std::int64_t i = 0; i < 8000; ++i) cycles.emplace_back(1'000'000 + i);
  const auto column = encode_column(integers(cycles));
  ASSERT_TRUE(column);
  EXPECT_EQ(column->codec, ColumnCodec::kLinear);
  EXPECT_LE(column->bytes.size(), 4U);
}

/// Whatever the bytes are, they are the cells that were asked for or refused.
TEST(ColumnCodec, AnyBytesAreReadOrRefused) {
  EXPECT_TRUE(rc::check([](const std::string& bytes) {
    const auto codec = static_cast<ColumnCodec>(*rc::gen::inRange(0, 7));
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(0, 200));
    ColumnCells cells;
    if (decode_column(codec, bytes, count, cells)) RC_ASSERT(size_of(cells) == count);
    std::vector<Nanoseconds> times;
    if (decode_times(bytes, count, times)) RC_ASSERT(times.size() == count);
  }));
}

}  // namespace
}  // namespace syncline
