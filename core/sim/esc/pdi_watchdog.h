// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "protocol/registers.h"
#include "sim/esc/watchdog_timer.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

/// PDI watchdog of an ESC (registers 0x0400, 0x0410, 0x0443 and bit 1 of the DL status; ESC data sheet II, 3.8):
/// restarted by each access of the PDI. Firmware that works asks the ESC all the time, so that only its end and its
/// return are told.
class PdiWatchdog {
 public:
  explicit PdiWatchdog(EscMemory& memory) : memory_(memory), timer_(memory, reg::kWatchdogPdi) {}

  /// 100 ms from power-on, with the usual divider.
  void implement_registers() {
    memory_.implement(reg::kWatchdogPdi, 2, EscMemory::kReadWrite);
    memory_.set<std::uint16_t>(reg::kWatchdogPdi, 1000);
  }
  [[nodiscard]] Nanoseconds deadline() const { return timer_.deadline(); }
  /// The last access was at `time`.
  void pdi_stops(Nanoseconds time) { timer_.restart(time); }
  /// Somebody has written the divider or the time.
  void settings_written() { timer_.settings_written(); }
  /// True when that makes the watchdog fine again.
  bool pdi_works() {
    timer_.stop();
    const bool expired = (memory_.u16(reg::kDlStatus) & kFine) == 0;
    show(true);
    return expired;
  }
  /// True when it expires now.
  bool advance_to(Nanoseconds time) {
    if (!timer_.advance_to(time)) return false;
    memory_.count(reg::kWatchdogCounterPdi);
    show(false);
    return true;
  }

 private:
  static constexpr unsigned kFine = 0x0002;  // of the DL status
  void show(bool fine) {
    const unsigned status = memory_.u16(reg::kDlStatus);
    memory_.set<std::uint16_t>(reg::kDlStatus, static_cast<std::uint16_t>(fine ? status | kFine : status & ~kFine));
  }

  EscMemory& memory_;
  WatchdogTimer timer_;
};

}  // namespace syncline::sim
