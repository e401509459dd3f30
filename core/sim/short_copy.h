// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "support/byte_order.h"

namespace syncline::sim {

/// Copies `from` into `to`, which is at least as long. What a slave exchanges in a cycle is mostly a byte or a word, for
/// which calling memcpy costs more than the copying.
inline void short_copy(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
  switch (from.size()) {
    case 1: to[0] = from[0]; break;
    case 2: store_le(to, load_le<std::uint16_t>(from)); break;
    case 4: store_le(to, load_le<std::uint32_t>(from)); break;
    case 8: store_le(to, load_le<std::uint64_t>(from)); break;
    default: std::ranges::copy(from, to.begin());
  }
}

/// Adds the bits of `from` to those of `to`, which is at least as long.
inline void short_or(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
  switch (from.size()) {
    case 1: to[0] = static_cast<std::uint8_t>(to[0] | from[0]); break;
    case 2: store_le(to, static_cast<std::uint16_t>(load_le<std::uint16_t>(to) | load_le<std::uint16_t>(from))); break;
    case 4: store_le(to, load_le<std::uint32_t>(to) | load_le<std::uint32_t>(from)); break;
    case 8: store_le(to, load_le<std::uint64_t>(to) | load_le<std::uint64_t>(from)); break;
    default:
      for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<std::uint8_t>(to[i] | from[i]);
  }
}

}  // namespace syncline::sim
