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

/// The same in two's complement; of none 0.
[[nodiscard]] constexpr std::int64_t le_signed_number(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return 0;
  const auto unused = bytes.size() < sizeof(std::uint64_t) ? 8 * (sizeof(std::uint64_t) - bytes.size()) : 0U;
  return static_cast<std::int64_t>(le_number(bytes) << unused) >> unused;
}

}  // namespace syncline
