// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/watchdog_timer.h"

#include "protocol/registers.h"
#include "sim/registers/esc_memory.h"

namespace syncline::sim {

Nanoseconds WatchdogTimer::set_timeout() const {
  constexpr Nanoseconds kDividerUnit = 40;  // ns
  const Nanoseconds tick = (memory_.u16(reg::kWatchdogDivider) + 2) * kDividerUnit;
  return memory_.u16(time_register_) * tick;
}

}  // namespace syncline::sim
