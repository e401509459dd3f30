// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/dc/local_clock.h"

namespace syncline::sim {

/// What an ESC keeps of cycles in which the device does the same over and over: outputs come with what they held
/// before, in time for a SYNC0, then that SYNC0 comes, and then the next outputs. They are counted, and the device is
/// told of them when something else happens: what it does with all but the last of them is known then, and the last
/// outputs are given to it as if they came only now. Times are true time.
struct RepeatedCycles {
  /// What the device does in each.
  struct Work {
    unsigned outputs = 0;         // SyncManager that brings them
    std::uint32_t renewed = 0;    // bit per SyncManager: written again with each SYNC0, with what it holds
    Nanoseconds calculation = 0;  // that outputs must come before SYNC0, at least
  };
  Work work{};
  bool repeating = false;
  bool awaits_sync0 = false;          // the outputs of this cycle are there
  std::uint64_t outputs_taken = 0;    // since the cycles are counted
  Nanoseconds taken_at = 0;           // the last of them
  Nanoseconds quiet_from = 0;         // end of the last frame: no SYNC0 before has been left out
  LocalClock::Moment behind_sync0{};  // a little later than the last SYNC0 that was counted
  std::uint64_t sync0 = 0;            // that one, in local time

  /// Time that is sure to pass while a clock that runs nearly true goes on by `local` ns.
  [[nodiscard]] static Nanoseconds surely(Nanoseconds local) { return local - local / kMargin; }
  /// Time by a clock that runs nearly true, at most, in which so much true time passes.
  [[nodiscard]] static Nanoseconds at_most(Nanoseconds time) { return time + time / kMargin + 1; }

 private:
  static constexpr Nanoseconds kMargin = 64;  // LocalClock::runs_nearly_true() is half as strict
};

}  // namespace syncline::sim
