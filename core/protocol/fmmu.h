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
  std::uint16_t length = 0;              // touched bytes
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
  /// Number of mapped bits.
  [[nodiscard]] std::uint32_t bit_length() const {
    return length == 0 ? 0 : (length - 1U) * 8U + logical_stop_bit + 1U - logical_start_bit;
  }
};

}  // namespace syncline
