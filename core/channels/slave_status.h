// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "channels/slave_evidence.h"
#include "channels/sm2_missed_status.h"
#include "support/types.h"

namespace syncline {

/// What is known of one slave while the bus runs.
struct SlaveStatus {
  std::uint16_t al_status = 0;  // register 0x0130; 0 = unknown, it does not answer
  std::uint16_t al_status_code = 0;
  Nanoseconds al_status_time = 0;  // host clock of the newest reading of both; 0: never, or it does not answer
  bool present = false;            // answers
  bool cable_broken = false;       // nothing comes back over the cable from the one that it hangs at
  Nanoseconds absent_since = 0;    // host clock; while it does not answer
  Nanoseconds moved = 0;           // host clock: when it went or came, or its cable broke or healed, last; 0: never
  bool dc_enabled = false;
  bool is_reference_clock = false;
  bool follows = false;  // the reference clock: there, with a clock, behind it in frame order
  bool deviation_valid = false;
  std::int32_t deviation_ns = 0;   // signed 0x092C; a deviation from the reference clock when it follows
  Nanoseconds deviation_time = 0;  // host clock of the reading
  std::uint32_t propagation_delay_ns = 0;
  Sm2MissedStatus sm2_missed;
  SlaveEvidence evidence;
  bool operator==(const SlaveStatus&) const = default;
};

}  // namespace syncline
