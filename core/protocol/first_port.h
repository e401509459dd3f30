// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/dl_status.h"

namespace syncline {

/// Active port that a frame reached before all others, by the times at which it came in at each (0x0900, 32 bits of a
/// clock that may wrap); the first one in the order of the ports where several have the same. Nothing where no port is
/// active, or the times contradict each other (more than 2.1 s apart).
[[nodiscard]] constexpr std::optional<unsigned> first_port(const std::array<bool, kPortCount>& active,
                                                           const std::array<std::uint32_t, kPortCount>& receive_times) {
  for (const unsigned candidate : kPortOrder) {
    if (!active[candidate]) continue;
    bool first = true;
    for (const unsigned other : kPortOrder) {
      if (!active[other]) continue;
      first = first && static_cast<std::int32_t>(receive_times[candidate] - receive_times[other]) <= 0;
    }
    if (first) return candidate;
  }
  return std::nullopt;
}

}  // namespace syncline
