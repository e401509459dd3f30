// SPDX-License-Identifier: Apache-2.0
#include "sim/process_data_watchdog.h"

#include "protocol/registers.h"

namespace syncline::sim {
namespace {

constexpr Nanoseconds kDividerUnit = 40;  // ns
constexpr std::uint16_t kActiveOrDisabled = 0x0001;

}  // namespace

void ProcessDataWatchdog::trigger(Nanoseconds time) {
  const Nanoseconds tick = (memory_.u16(reg::kWatchdogDivider) + 2) * kDividerUnit;
  const Nanoseconds timeout = memory_.u16(reg::kWatchdogProcessData) * tick;
  deadline_ = timeout == 0 ? kNever : time + timeout;
  memory_.set<std::uint16_t>(reg::kWatchdogStatus, kActiveOrDisabled);
}

bool ProcessDataWatchdog::expire() {
  deadline_ = kNever;
  memory_.set<std::uint16_t>(reg::kWatchdogStatus, 0);
  memory_.count(reg::kWatchdogCounterProcessData);
  return true;
}

}  // namespace syncline::sim
