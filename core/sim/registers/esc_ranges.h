// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace syncline::sim {

/// Two ranges of an ESC's address space have an address in common.
[[nodiscard]] constexpr bool overlaps(std::uint32_t a, std::size_t a_size, std::uint32_t b, std::size_t b_size) {
  return a < b + b_size && b < a + a_size;
}

}  // namespace syncline::sim
