// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace syncline {

/// A number whose `count` lowest bits are set; all from 64 on.
[[nodiscard]] constexpr std::uint64_t low_bits(std::size_t count) {
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// Copies `bits` bits between bit offsets of byte arrays, the lowest bit of a byte first; the bits around them stay.
/// Both arrays have room for them.
inline void copy_bits(std::span<std::uint8_t> to, std::size_t to_bit, std::span<const std::uint8_t> from,
                      std::size_t from_bit, std::size_t bits) {
  for (std::size_t i = 0; i < bits; ++i) {
    const bool value = ((from[(from_bit + i) / 8] >> ((from_bit + i) % 8)) & 1) != 0;
    const auto mask = static_cast<std::uint8_t>(1U << ((to_bit + i) % 8));
    auto& byte = to[(to_bit + i) / 8];
    byte = static_cast<std::uint8_t>(value ? byte | mask : byte & ~mask);
  }
}

}  // namespace syncline
