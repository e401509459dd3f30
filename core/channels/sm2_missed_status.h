// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/values/miss_cause.h"
#include "support/types.h"

namespace syncline {

/// Missed SM2 events: the slave's counter and where it was read, and what the master makes of it and of what it knows
/// of each cycle (dc/sync_event_account.h).
struct Sm2MissedStatus {
  bool valid = false;       // the counter was read
  std::uint32_t value = 0;  // as it was read last
  Nanoseconds time = 0;     // host clock of that reading
  std::uint16_t index = 0x1C32;
  std::uint8_t sub_index = 0;        // 0x0B or 0x0C, by object name or device profile
  std::uint8_t other_sub_index = 0;  // neither says which: the other one of the two, else 0
  std::uint32_t other_value = 0;
  bool known = false;          // the following count
  std::uint32_t missed = 0;    // since the slave was in OP first
  std::uint32_t computed = 0;  // part of it that the slave did not tell: it fell, or has no counter
  bool at_least = false;
  dc::MissesByCause by_cause{};
  std::uint32_t integrator = 0;          // what 0x10F1 makes of the misses
  bool settling = false;                 // in OP again, and of the integrator, which begins anew, nobody knows yet
  std::uint32_t integrator_highest = 0;  // so far
  std::uint32_t limit = 0;               // 0x10F1:02, at which the slave gives up; 0 = never, or not told
  /// What is shown: the followed count, which a fall does not clear, or without one the slave's own.
  [[nodiscard]] std::uint32_t total() const { return known ? missed : value; }
  bool operator==(const Sm2MissedStatus&) const = default;
};

}  // namespace syncline
