// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace syncline {

/// A little-endian number of as many bytes as there are; of more than eight the first eight, of none 0.
[[nodiscard]] constexpr std::uint64_t le_number(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size() && i < sizeof value; ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
  return value;
}

}  // namespace syncline
