// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/types.h"

namespace syncline {

/// Largest multiple of `width` (> 0) that is not above `time`.
[[nodiscard]] constexpr Nanoseconds floor_to(Nanoseconds time, Nanoseconds width) {
  const auto rest = time % width;
  return time - (rest < 0 ? rest + width : rest);
}

}  // namespace syncline
