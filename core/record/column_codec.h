// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "trace/signals.h"

/// How the cells of one signal over one block lie in a BLOB (docs/recording.md). Little endian; integers as zigzag
/// LEB128. A block without any value has no BLOB.
namespace syncline {

enum class ColumnCodec : std::uint8_t {
  kLinear = 1,  // first value, step: all cells are there and rise alike
  kDelta = 2,   // first value, then differences: all cells are there
  kMasked = 3,  // a bit a cell, lowest first; then as kDelta those whose bit is set
  kFloat = 4,   // 32-bit floats; not-a-number: no value
};

struct Column {
  ColumnCodec codec = ColumnCodec::kLinear;
  std::string bytes;
};

using Cells = std::vector<std::optional<SignalNumber>>;

/// A column out of its BLOB: numbers of one kind.
struct ColumnCells {
  std::vector<std::int64_t> integers;  // of kFloat empty
  std::vector<float> floats;           // of the others empty; not-a-number: no value
  std::vector<std::uint8_t> there;     // of kMasked, a cell: 0: no value, and the integer is 0; empty: all have one
};

/// Nothing when no cell has a value. The cells of a column are all integers or all floats.
[[nodiscard]] std::optional<Column> encode_column(std::span<const std::optional<SignalNumber>> cells);
/// False when the bytes are no `count` cells in this codec, to the last byte; what is in `out` then is nothing.
[[nodiscard]] bool decode_column(ColumnCodec codec, std::string_view bytes, std::size_t count, ColumnCells& out);

/// Times or other integers, first value and differences.
[[nodiscard]] std::string encode_times(std::span<const Nanoseconds> times);
[[nodiscard]] bool decode_times(std::string_view bytes, std::size_t count, std::vector<Nanoseconds>& out);
[[nodiscard]] std::string encode_floats(std::span<const float> values);
[[nodiscard]] bool decode_floats(std::string_view bytes, std::size_t count, std::vector<float>& out);

}  // namespace syncline
