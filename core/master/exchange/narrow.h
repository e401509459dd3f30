// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "support/types.h"

namespace syncline {

/// The value, or the end of the type that lies nearest to it.
[[nodiscard]] constexpr std::int32_t to_32(Nanoseconds value) {
  return static_cast<std::int32_t>(std::clamp<Nanoseconds>(value, INT32_MIN, INT32_MAX));
}
[[nodiscard]] constexpr std::uint16_t to_16(std::uint64_t count) {
  return static_cast<std::uint16_t>(std::min<std::uint64_t>(count, UINT16_MAX));
}

}  // namespace syncline
