// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/watchdog_timer.h"

#include "protocol/registers.h"

namespace syncline::sim {

void WatchdogTimer::restart(Nanoseconds time) {
  constexpr Nanoseconds kDividerUnit = 40;  // ns
  const Nanoseconds tick = (memory_.u16(reg::kWatchdogDivider) + 2) * kDividerUnit;
  const Nanoseconds timeout = memory_.u16(time_register_) * tick;
  deadline_ = timeout == 0 ? kNever : time + timeout;
}

}  // namespace syncline::sim
