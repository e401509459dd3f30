// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "channels/values/sync_state.h"
#include "support/types.h"

namespace syncline {

/// Whether the slaves are in sync with their reference clock, and from what that was decided (dc/sync_verdict.h).
struct DcStatus {
  bool enabled = false;
  int reference_clock = -1;                // position
  SyncState state = SyncState::kNotReady;  // the verdict on the slaves, see dc/sync_verdict.h; kNotMonitored also while
                                           // nobody follows
  Nanoseconds since = 0;                   // host clock: the state is the same since then
  bool monitored = false;                  // sync-window monitoring configured and at least two DC slaves
  std::uint32_t limit_ns = 0;
  std::uint32_t deviation_ored_ns = 0;  // of all clocks, those in front of the reference clock and itself included
  std::optional<std::uint32_t> deviation_ns;  // largest latest reading of those that follow, monitored or not
  std::uint16_t followers = 0;                // slaves that follow the reference clock
  std::uint16_t over_limit = 0;               // of them, by their own readings
  bool all_alike = false;          // all of them are off to the same side, about as far: the reference clock moved
  int culprit = -1;                // else the one furthest over the limit
  Nanoseconds newest_age_ns = -1;  // of the latest own reading of any of them; -1: none yet
  Nanoseconds oldest_age_ns = -1;  // since something was heard of each of them
  std::optional<double> settled_after_ms;  // from the first cyclic frame until the settle time began
  Nanoseconds sync_base = 0;               // SYNC0 lies at sync_base + n * cycle + shift in system time
  Nanoseconds start_time = 0;              // system time at which SYNC0 starts, as sent to a slave last; 0 = not yet
  bool operator==(const DcStatus&) const = default;
};

}  // namespace syncline
