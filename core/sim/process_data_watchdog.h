// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "sim/esc_memory.h"
#include "support/types.h"

namespace syncline::sim {

/// Process data watchdog of an ESC (registers 0x0400, 0x0420, 0x0440, 0x0442; ESC data sheet II, 3.8): started by
/// the first write to a SyncManager with the watchdog trigger, restarted by each further one.
class ProcessDataWatchdog {
 public:
  explicit ProcessDataWatchdog(EscMemory& memory) : memory_(memory) {}

  void trigger(Nanoseconds time);
  /// True when it expires now: once, until the next trigger.
  bool advance_to(Nanoseconds time) { return time >= deadline_ && expire(); }
  /// The SyncManager was switched off: nothing to watch.
  void stop() { deadline_ = kNever; }

 private:
  static constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();
  bool expire();

  EscMemory& memory_;
  Nanoseconds deadline_ = kNever;
};

}  // namespace syncline::sim
