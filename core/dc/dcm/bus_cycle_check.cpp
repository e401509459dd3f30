// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_cycle_check.h"

#include <cstdlib>

namespace syncline::dc {
namespace {

/// Long enough that a master shift's acquisition and single late cycles stay below the threshold.
constexpr Nanoseconds kWindow = kSecond;
constexpr std::int64_t kMinimumCycles = 64;
constexpr Nanoseconds kTolerance = 50;  // a 50th

}  // namespace

void BusCycleCheck::observe(Nanoseconds scheduled_time) {
  if (!begin_) {
    begin_ = scheduled_time;
    return;
  }
  ++count_;
  const auto elapsed = scheduled_time - *begin_;
  if (elapsed < kWindow || count_ < kMinimumCycles) return;
  const auto wanted = count_ * cycle_;
  wrong_ = std::abs(elapsed - wanted) > wanted / kTolerance;
  begin_ = scheduled_time;
  count_ = 0;
}

}  // namespace syncline::dc
