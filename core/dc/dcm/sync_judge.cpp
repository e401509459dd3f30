// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/sync_judge.h"

#include <cstdlib>

namespace syncline::dc {

SyncJudge::SyncJudge(const DcmSettings& settings)
    : limit_(settings.in_sync_limit),
      settle_(settings.in_sync_settle_time_ms * kMillisecond),
      delay_(settings.start_delay_ms * kMillisecond) {}

void SyncJudge::start(Nanoseconds time) {
  start_ = time;
  good_since_.reset();
  bad_since_.reset();
  after_.reset();
  in_sync_ = false;
}

void SyncJudge::observe(Nanoseconds time, Nanoseconds error) {
  if (time - start_ < delay_) return;
  if (std::abs(error) <= limit_) {
    bad_since_.reset();
    if (!good_since_) good_since_ = time;
    if (!in_sync_ && time - *good_since_ >= settle_) {
      in_sync_ = true;
      if (!after_) after_ = time - start_;
    }
    return;
  }
  if (!in_sync_) {
    good_since_.reset();
    return;
  }
  if (!bad_since_) bad_since_ = time;
  if (time - *bad_since_ >= kPatience) {
    in_sync_ = false;
    good_since_.reset();
  }
}

}  // namespace syncline::dc
