// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/registers.h"
#include "sim/esc/watchdog_timer.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// Process data watchdog of an ESC (registers 0x0400, 0x0420, 0x0440, 0x0442; ESC data sheet II, 3.8): started by
/// the first write to a SyncManager with the watchdog trigger, restarted by each further one.
class ProcessDataWatchdog {
 public:
  explicit ProcessDataWatchdog(EscMemory& memory) : memory_(memory), timer_(memory, reg::kWatchdogProcessData) {}

  /// 100 ms from power-on, with the usual divider.
  void implement_registers() {
    memory_.implement(reg::kWatchdogProcessData, 2, EscMemory::kReadWrite);
    memory_.set<std::uint16_t>(reg::kWatchdogProcessData, 1000);
  }
  void trigger(Nanoseconds time) {
    timer_.restart(time);
    if (expired_) show(false);
  }
  /// True when it expires now: once, until the next trigger.
  bool advance_to(Nanoseconds time) { return timer_.advance_to(time) && expire(); }
  [[nodiscard]] Nanoseconds deadline() const { return timer_.deadline(); }
  /// The SyncManager was switched off: nothing to watch.
  void stop() { timer_.stop(); }
  /// Somebody has written the divider or the time.
  void settings_written() { timer_.settings_written(); }

 private:
  bool expire();
  void show(bool expired);

  EscMemory& memory_;
  WatchdogTimer timer_;
  bool expired_ = false;  // as the status shows it
};

}  // namespace syncline::sim
