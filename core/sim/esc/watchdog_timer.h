// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "support/types.h"

namespace syncline::sim {

class EscMemory;

/// What both watchdogs of an ESC have in common: a time in ticks of the divider (0x0400) after which they expire, once,
/// unless they are restarted before (ESC data sheet II, 3.8).
class WatchdogTimer {
 public:
  /// `time_register` holds the number of ticks, 0: never.
  WatchdogTimer(const EscMemory& memory, std::uint16_t time_register)
      : memory_(memory), time_register_(time_register) {}

  void restart(Nanoseconds time) {
    if (timeout_ == kUnknown) timeout_ = set_timeout();
    deadline_ = timeout_ == 0 ? kNever : time + timeout_;
  }
  /// Somebody has written the divider or the time: they count from the next restart on.
  void settings_written() { timeout_ = kUnknown; }
  void stop() { deadline_ = kNever; }
  /// When it will expire, unless it is restarted; the end of time: not at all.
  [[nodiscard]] Nanoseconds deadline() const { return deadline_; }
  /// True when it expires now.
  bool advance_to(Nanoseconds time) {
    if (time < deadline_) return false;
    stop();
    return true;
  }

 private:
  static constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();
  static constexpr Nanoseconds kUnknown = -1;
  [[nodiscard]] Nanoseconds set_timeout() const;

  const EscMemory& memory_;
  std::uint16_t time_register_;
  Nanoseconds timeout_ = kUnknown;  // as the registers say; 0: none
  Nanoseconds deadline_ = kNever;
};

}  // namespace syncline::sim
