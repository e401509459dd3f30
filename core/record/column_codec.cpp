// SPDX-License-Identifier: Apache-2.0
#include "record/column_codec.h"

#include <bit>
#include <cmath>
#include <limits>

namespace syncline {
namespace {

void put_varint(std::string& out, std::uint64_t value) {
  while (value >= 0x80) {
    out += static_cast<char>(value | 0x80);
    value >>= 7;
  }
  out += static_cast<char>(value);
}

constexpr std::uint64_t zigzag(std::uint64_t difference) { return (difference << 1) ^ (0 - (difference >> 63)); }
constexpr std::uint64_t unzigzag(std::uint64_t value) { return (value >> 1) ^ (0 - (value & 1)); }

/// Differences wrap, so that every pair of integers has one.
void put_difference(std::string& out, std::int64_t from, std::int64_t to) {
  put_varint(out, zigzag(static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from)));
}

/// Takes varints off the front; remembers that there was none.
class Varints {
 public:
  explicit Varints(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}
  std::int64_t after(std::int64_t from) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(from) + unzigzag(next()));
  }
  [[nodiscard]] bool done() const { return good_ && at_ == end_; }
  [[nodiscard]] bool good() const { return good_; }

 private:
  std::uint64_t next() {
    // Most differences are small.
    if (at_ != end_ && static_cast<std::uint8_t>(*at_) < 0x80) return static_cast<std::uint8_t>(*at_++);
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && at_ != end_; shift += 7) {
      const auto byte = static_cast<std::uint8_t>(*at_++);
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80) return value;
    }
    good_ = false;
    return 0;
  }

  const char* at_;
  const char* end_;
  bool good_ = true;
};

void put_float(std::string& out, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>(bits >> shift);
}

float float_at(std::string_view bytes, std::size_t index) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i)
    bits |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(bytes[index * 4 + i])) << (8 * i);
  return std::bit_cast<float>(bits);
}

bool rises_alike(const std::vector<std::int64_t>& values) {
  const auto difference = [&](std::size_t i) {
    return static_cast<std::uint64_t>(values[i]) - static_cast<std::uint64_t>(values[i - 1]);
  };
  for (std::size_t i = 2; i < values.size(); ++i) {
    if (difference(i) != difference(1)) return false;
  }
  return true;
}

Column encode_integers(std::span<const std::optional<SignalNumber>> cells, const std::vector<std::int64_t>& values) {
  Column column;
  if (values.size() == cells.size() && rises_alike(values)) {
    put_difference(column.bytes, 0, values.front());
    put_difference(column.bytes, values.front(), values.size() > 1 ? values[1] : values.front());
    return column;
  }
  column.codec = ColumnCodec::kDelta;
  if (values.size() < cells.size()) {
    column.codec = ColumnCodec::kMasked;
    column.bytes.assign((cells.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i])
        column.bytes[i / 8] = static_cast<char>(static_cast<std::uint8_t>(column.bytes[i / 8]) | 1U << (i % 8));
    }
  }
  std::int64_t before = 0;
  for (const auto value : values) {
    put_difference(column.bytes, before, value);
    before = value;
  }
  return column;
}

bool decode_linear(std::string_view bytes, std::size_t count, std::vector<std::int64_t>& out) {
  Varints varints(bytes);
  const auto first = varints.after(0);
  const auto step = static_cast<std::uint64_t>(varints.after(first)) - static_cast<std::uint64_t>(first);
  out.resize(count);
  auto value = static_cast<std::uint64_t>(first);
  for (auto& cell : out) {
    cell = static_cast<std::int64_t>(value);
    value += step;
  }
  return varints.done();
}

bool decode_differences(std::string_view bytes, std::size_t count, std::vector<std::int64_t>& out) {
  if (count > bytes.size()) return false;
  Varints varints(bytes);
  out.resize(count);
  std::int64_t value = 0;
  for (auto& cell : out) cell = value = varints.after(value);
  return varints.done();
}

bool decode_masked(std::string_view bytes, std::size_t count, ColumnCells& out) {
  const auto mask = (count + 7) / 8;
  if (count == 0 || bytes.size() < mask) return false;
  Varints varints(bytes.substr(mask));
  out.there.resize(count);
  out.integers.resize(count);
  std::int64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    out.there[i] = static_cast<std::uint8_t>(bytes[i / 8]) >> (i % 8) & 1U;
    if (out.there[i] != 0) out.integers[i] = value = varints.after(value);
  }
  return varints.done();
}

}  // namespace

std::optional<Column> encode_column(std::span<const std::optional<SignalNumber>> cells) {
  std::vector<std::int64_t> integers;
  std::vector<float> floats;
  bool any_float = false;
  for (const auto& cell : cells) {
    const auto* const real = cell ? std::get_if<float>(&*cell) : nullptr;
    any_float = any_float || real != nullptr;
    floats.push_back(real != nullptr ? *real : std::numeric_limits<float>::quiet_NaN());
    if (cell && real == nullptr) integers.push_back(std::get<std::int64_t>(*cell));
  }
  if (any_float) return Column{ColumnCodec::kFloat, encode_floats(floats)};
  if (integers.empty()) return std::nullopt;
  return encode_integers(cells, integers);
}

bool decode_column(ColumnCodec codec, std::string_view bytes, std::size_t count, ColumnCells& out) {
  out.integers.clear();
  out.floats.clear();
  out.there.clear();
  switch (codec) {
    case ColumnCodec::kLinear:
      return decode_linear(bytes, count, out.integers);
    case ColumnCodec::kDelta:
      return decode_differences(bytes, count, out.integers);
    case ColumnCodec::kMasked:
      return decode_masked(bytes, count, out);
    case ColumnCodec::kFloat:
      return decode_floats(bytes, count, out.floats);
  }
  return false;
}

std::string encode_times(std::span<const Nanoseconds> times) {
  std::string bytes;
  Nanoseconds before = 0;
  for (const auto time : times) {
    put_difference(bytes, before, time);
    before = time;
  }
  return bytes;
}

bool decode_times(std::string_view bytes, std::size_t count, std::vector<Nanoseconds>& out) {
  out.clear();
  Varints varints(bytes);
  Nanoseconds time = 0;
  for (std::size_t i = 0; i < count; ++i) {
    time = varints.after(time);
    if (!varints.good()) return false;
    out.push_back(time);
  }
  return varints.done();
}

std::string encode_floats(std::span<const float> values) {
  std::string bytes;
  bytes.reserve(values.size() * 4);
  for (const auto value : values) put_float(bytes, value);
  return bytes;
}

bool decode_floats(std::string_view bytes, std::size_t count, std::vector<float>& out) {
  out.clear();
  if (count > bytes.size() || bytes.size() != count * 4) return false;
  out.resize(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = float_at(bytes, i);
  return true;
}

}  // namespace syncline
