// SPDX-License-Identifier: Apache-2.0
#include "channels/values/sync_obstacle_text.h"

namespace syncline::dc {

std::string_view obstacle_text(SyncObstacle obstacle) {
  switch (obstacle) {
    case SyncObstacle::kNone:
      return {};
    case SyncObstacle::kNoReferenceClock:
      return "no reference clock leads";
    case SyncObstacle::kNoReading:
      return "the reference clock's time does not come";
    case SyncObstacle::kClockStep:
      return "the reference clock has stepped";
    case SyncObstacle::kErrorCode:
      return "the controller reports an error";
    case SyncObstacle::kControlError:
      return "the schedule is not within its limit";
    case SyncObstacle::kCyclesLeftOut:
      return "cycles were left out, the host came too late";
    case SyncObstacle::kLateFrames:
      return "a frame was sent later than the set value allows";
    case SyncObstacle::kSettling:
      return "settling behind an interruption";
    case SyncObstacle::kToExternalClock:
      return "the reference clock is on its way to the external clock";
    case SyncObstacle::kExternalClock:
      return "the external clock is not where the reference clock is";
  }
  return {};
}

}  // namespace syncline::dc
