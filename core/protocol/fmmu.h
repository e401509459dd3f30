// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace syncline {

/// FMMU register image, 16 bytes at 0x0600 + 16 n (ETG.1000.4, table 56).
struct Fmmu {
  static constexpr std::size_t kSize = 16;
  std::uint32_t logical_start = 0;
  std::uint16_t length = 0;  // touched bytes
  std::uint8_t logical_start_bit = 0;
  std::uint8_t logical_stop_bit = 7;
  std::uint16_t physical_start = 0;
  std::uint8_t physical_start_bit = 0;
  bool read = false;
  bool write = false;
  bool active = false;

  bool operator==(const Fmmu&) const = default;
  [[nodiscard]] std::array<std::uint8_t, kSize> encode() const;
  [[nodiscard]] static Fmmu decode(std::span<const std::uint8_t, kSize> bytes);
  /// Number of mapped bits; 0 where the bits contradict each other.
  [[nodiscard]] std::uint32_t bit_length() const {
    const auto end = length * 8U + logical_stop_bit + 1U;  // 8 more than behind the last bit
    const auto begin = logical_start_bit + 8U;
    return length == 0 || end < begin ? 0 : end - begin;
  }
};

}  // namespace syncline
