// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "support/byte_order.h"

namespace syncline::sim {

/// Words that may overlap instead of a loop over bytes; `from` and `to` do not.
inline void copy_words(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
  constexpr std::size_t kWord = 8, kLongest = 64;
  const auto size = from.size();
  if (size > kLongest || size < 3) {
    std::ranges::copy(from, to.begin());
  } else if (size < kWord) {
    const auto half = size < 4 ? 2U : 4U;
    const auto first = from.first(half), last = from.last(half);
    if (half == 2) {
      store_le(to, load_le<std::uint16_t>(first));
      store_le(to.subspan(size - half), load_le<std::uint16_t>(last));
    } else {
      store_le(to, load_le<std::uint32_t>(first));
      store_le(to.subspan(size - half), load_le<std::uint32_t>(last));
    }
  } else {
    for (std::size_t at = 0; at + kWord < size; at += kWord)
      store_le(to.subspan(at), load_le<std::uint64_t>(from.subspan(at)));
    store_le(to.subspan(size - kWord), load_le<std::uint64_t>(from.subspan(size - kWord)));
  }
}

/// Copies `from` into `to`, which is at least as long. What a slave exchanges in a cycle is mostly a byte or a word,
/// for which calling memcpy costs more than the copying.
inline void short_copy(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
  switch (from.size()) {
    case 1:
      to[0] = from[0];
      break;
    case 2:
      store_le(to, load_le<std::uint16_t>(from));
      break;
    case 4:
      store_le(to, load_le<std::uint32_t>(from));
      break;
    case 8:
      store_le(to, load_le<std::uint64_t>(from));
      break;
    default:
      copy_words(from, to);
  }
}

[[nodiscard]] inline bool short_equal(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  constexpr std::size_t kWord = 8;
  if (a.size() != b.size()) return false;
  if (a.size() == 4) return load_le<std::uint32_t>(a) == load_le<std::uint32_t>(b);
  if (a.size() < kWord || a.size() > 4 * kWord) return std::ranges::equal(a, b);
  for (std::size_t at = kWord; at + kWord < a.size(); at += kWord) {
    if (load_le<std::uint64_t>(a.subspan(at)) != load_le<std::uint64_t>(b.subspan(at))) return false;
  }
  const auto last = a.size() - kWord;  // words that may overlap
  return load_le<std::uint64_t>(a) == load_le<std::uint64_t>(b) &&
         load_le<std::uint64_t>(a.subspan(last)) == load_le<std::uint64_t>(b.subspan(last));
}

/// Adds the bits of `from` to those of `to`, which is at least as long.
inline void short_or(std::span<const std::uint8_t> from, std::span<std::uint8_t> to) {
  switch (from.size()) {
    case 1:
      to[0] = static_cast<std::uint8_t>(to[0] | from[0]);
      break;
    case 2:
      store_le(to, static_cast<std::uint16_t>(load_le<std::uint16_t>(to) | load_le<std::uint16_t>(from)));
      break;
    case 4:
      store_le(to, load_le<std::uint32_t>(to) | load_le<std::uint32_t>(from));
      break;
    case 8:
      store_le(to, load_le<std::uint64_t>(to) | load_le<std::uint64_t>(from));
      break;
    default:
      for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<std::uint8_t>(to[i] | from[i]);
  }
}

}  // namespace syncline::sim
