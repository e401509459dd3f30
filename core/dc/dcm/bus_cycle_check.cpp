// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/bus_cycle_check.h"

#include <algorithm>
#include <cstdlib>

namespace syncline::dc {
namespace {

/// Long enough that a master shift's acquisition and single late cycles stay below the threshold.
constexpr Nanoseconds kWindow = kSecond;
constexpr std::int64_t kMinimumCycles = 64;
constexpr Nanoseconds kTolerance = 50;  // a 50th
constexpr Nanoseconds kSilence = 50 * kMillisecond;

}  // namespace

void BusCycleCheck::observe(Nanoseconds scheduled_time, bool answered) {
  const auto passed = last_ ? scheduled_time - *last_ : cycle_;
  last_ = scheduled_time;
  if (!answered && !silent_since_) silent_since_ = scheduled_time;
  const bool was_silent = silent_since_ && scheduled_time - *silent_since_ >= kSilence;
  if (answered) silent_since_.reset();
  if (!begin_ || was_silent) {
    begin(scheduled_time);
    return;
  }
  ++count_;
  standstill_ = std::max(standstill_, passed - cycle_);
  const auto elapsed = scheduled_time - *begin_ - standstill_;
  if (elapsed < kWindow || count_ < kMinimumCycles) return;
  const auto wanted = count_ * cycle_;
  wrong_ = std::abs(elapsed - wanted) > wanted / kTolerance;
  begin(scheduled_time);
}

void BusCycleCheck::begin(Nanoseconds time) {
  begin_ = time;
  count_ = 0;
  standstill_ = 0;
}

}  // namespace syncline::dc
