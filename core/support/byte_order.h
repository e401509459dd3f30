// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace syncline {

/// Reads an unsigned little-endian integer; `bytes` must hold at least sizeof(T) bytes
/// (callers that take foreign input use ByteReader, which checks).
template <std::unsigned_integral T>
[[nodiscard]] constexpr T load_le(std::span<const std::uint8_t> bytes) {
  if (!std::is_constant_evaluated() && std::endian::native == std::endian::little) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    value |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
  }
  return static_cast<T>(value);
}

/// Writes an unsigned little-endian integer into the first sizeof(T) bytes.
template <std::unsigned_integral T>
constexpr void store_le(std::span<std::uint8_t> bytes, T value) {
  if (!std::is_constant_evaluated() && std::endian::native == std::endian::little) {
    std::memcpy(bytes.data(), &value, sizeof(T));
    return;
  }
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes[i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
  }
}

/// Bounds-checked little-endian cursor over foreign bytes. After the first read beyond the end
/// ok() is false for good and every further read gives zero, so a parser can read a whole
/// structure and check once.
class ByteReader {
 public:
  explicit constexpr ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <std::unsigned_integral T>
  [[nodiscard]] constexpr T read() {
    const auto part = take(sizeof(T));
    return part.size() == sizeof(T) ? load_le<T>(part) : T{0};
  }
  [[nodiscard]] constexpr std::uint8_t u8() { return read<std::uint8_t>(); }
  [[nodiscard]] constexpr std::uint16_t u16() { return read<std::uint16_t>(); }
  [[nodiscard]] constexpr std::uint32_t u32() { return read<std::uint32_t>(); }
  [[nodiscard]] constexpr std::uint64_t u64() { return read<std::uint64_t>(); }

  /// The next `count` bytes, or an empty span (and ok() == false) when there are not so many.
  constexpr std::span<const std::uint8_t> take(std::size_t count) {
    if (!ok_ || count > remaining()) {
      ok_ = false;
      return {};
    }
    const auto part = bytes_.subspan(position_, count);
    position_ += count;
    return part;
  }
  constexpr void skip(std::size_t count) { (void)take(count); }

  [[nodiscard]] constexpr bool ok() const { return ok_; }
  [[nodiscard]] constexpr std::size_t remaining() const { return bytes_.size() - position_; }
  [[nodiscard]] constexpr std::size_t position() const { return position_; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
  bool ok_ = true;
};

/// Appends little-endian integers and bytes to a vector.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  template <std::unsigned_integral T>
  ByteWriter& write(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      out_.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
    }
    return *this;
  }
  ByteWriter& u8(std::uint8_t v) { return write(v); }
  ByteWriter& u16(std::uint16_t v) { return write(v); }
  ByteWriter& u32(std::uint32_t v) { return write(v); }
  ByteWriter& u64(std::uint64_t v) { return write(v); }
  ByteWriter& bytes(std::span<const std::uint8_t> data) {
    out_.insert(out_.end(), data.begin(), data.end());
    return *this;
  }
  ByteWriter& zeros(std::size_t count) {
    out_.insert(out_.end(), count, std::uint8_t{0});
    return *this;
  }

 private:
  std::vector<std::uint8_t>& out_;
};

/// Little-endian bytes of an integer, for init commands and SDO data.
template <std::unsigned_integral T>
[[nodiscard]] std::vector<std::uint8_t> le_bytes(T value) {
  std::vector<std::uint8_t> out;
  ByteWriter(out).write(value);
  return out;
}

}  // namespace syncline
