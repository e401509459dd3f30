// SPDX-License-Identifier: Apache-2.0
#include "sim/esc/process_data_watchdog.h"

namespace syncline::sim {
namespace {

constexpr std::uint16_t kActiveOrDisabled = 0x0001;

}  // namespace

bool ProcessDataWatchdog::expire() {
  show(true);
  memory_.count(reg::kWatchdogCounterProcessData);
  return true;
}

void ProcessDataWatchdog::show(bool expired) {
  expired_ = expired;
  memory_.set<std::uint16_t>(reg::kWatchdogStatus, expired ? std::uint16_t{0} : kActiveOrDisabled);
}

}  // namespace syncline::sim
