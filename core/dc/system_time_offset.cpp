// SPDX-License-Identifier: Apache-2.0
#include "dc/system_time_offset.h"

namespace syncline::dc {

std::uint64_t system_time_offset(Nanoseconds reference_time_at_latch, std::uint64_t local_time_at_latch,
                                 std::uint32_t delay_ns, bool clock_is_64bit) {
  // The slave latched delay_ns after the reference clock did.
  const auto wanted = static_cast<std::uint64_t>(reference_time_at_latch) + delay_ns;
  const auto offset = wanted - local_time_at_latch;
  return clock_is_64bit ? offset : offset & 0xFFFF'FFFFU;
}

}  // namespace syncline::dc
