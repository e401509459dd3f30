// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace syncline::dc {

/// What stands between the master and "in sync", the first of these that holds.
enum class SyncObstacle : std::uint8_t {
  kNone,
  kNoReferenceClock,  // nobody leads
  kNoReading,         // the reference clock's time has not come for a while
  kClockStep,         // the reference clock stepped within the settle time
  kErrorCode,         // the controller has an error, DCM_E_...
  kControlError,      // the schedule is not within the limit, or not for the settle time yet
  kCyclesLeftOut,     // within the settle time
  kLateFrames,        // later than the set value allows, within the settle time
  kSettling,          // what was in the way is gone for less than the settle time
  kToExternalClock,   // DCX: the reference clock goes to where it has not met the external clock yet
  kExternalClock,     // DCX: they had met, and are apart
};

/// Not of the host's schedule, but of what it follows.
[[nodiscard]] constexpr bool is_of_external_clock(SyncObstacle obstacle) {
  return obstacle == SyncObstacle::kToExternalClock || obstacle == SyncObstacle::kExternalClock;
}

}  // namespace syncline::dc
