// SPDX-License-Identifier: Apache-2.0
#include "dc/master_verdict.h"

namespace syncline::dc {

void MasterVerdict::distrust(Nanoseconds time) { distrusted_ = time; }

void MasterVerdict::observe(const Input& input) {
  if (input.read) {
    if (input.time - read_ > settings_.stale) distrust(input.time);
    read_ = input.time;
  }
  if (input.clock_stepped) stepped_ = input.time;
  if (input.skipped_cycles > 0) skipped_ = input.time;
  if (too_late(input.frame_error)) late_ = input.time;
  obstacle_ = find(input);
  schedule_in_sync_ = input.schedule_in_sync && input.external == SyncObstacle::kNone && input.led &&
                      input.time - read_ <= settings_.stale && !within_settle(distrusted_, input.time);
}

SyncObstacle MasterVerdict::find(const Input& input) const {
  if (!input.led) return SyncObstacle::kNoReferenceClock;
  if (input.time - read_ > settings_.stale) return SyncObstacle::kNoReading;
  if (within_settle(stepped_, input.time)) return SyncObstacle::kClockStep;
  if (input.error_code != 0) return SyncObstacle::kErrorCode;
  if (!input.schedule_in_sync) return SyncObstacle::kControlError;
  if (input.external != SyncObstacle::kNone) return input.external;
  if (within_settle(skipped_, input.time)) return SyncObstacle::kCyclesLeftOut;
  if (within_settle(late_, input.time)) return SyncObstacle::kLateFrames;
  if (within_settle(distrusted_, input.time)) return SyncObstacle::kSettling;
  return SyncObstacle::kNone;
}

}  // namespace syncline::dc
