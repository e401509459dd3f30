// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/process_data_watchdog.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kActiveOrDisabled = 0x0001;

}  // namespace

void ProcessDataWatchdog::trigger(Nanoseconds time) {
  timer_.restart(time);
  memory_.set<std::uint16_t>(reg::kWatchdogStatus, kActiveOrDisabled);
}

bool ProcessDataWatchdog::expire() {
  memory_.set<std::uint16_t>(reg::kWatchdogStatus, 0);
  memory_.count(reg::kWatchdogCounterProcessData);
  return true;
}

}  // namespace syncline::sim
