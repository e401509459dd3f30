// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace syncline::sim {

/// Copies `from` into `to`, which is at least as long. What a slave exchanges in a cycle is mostly a few bytes, for which
/// calling memcpy costs more than the copying.
inline void short_copy(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
  constexpr std::size_t kShort = 8;
  if (from.size() > kShort) {
    std::ranges::copy(from, to.begin());
    return;
  }
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i];
}

}  // namespace syncline::sim
