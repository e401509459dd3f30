// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/sync_judge.h"

#include <cstdlib>

#include "config/dcm_settings.h"

namespace syncline::dc {

SyncJudge::SyncJudge(const DcmSettings& settings)
    : limit_(settings.in_sync_limit),
      settle_(settings.in_sync_settle_time_ms * kMillisecond),
      delay_(settings.start_delay_ms * kMillisecond) {}

void SyncJudge::start(Nanoseconds time) {
  start_ = time;
  good_since_.reset();
  bad_since_.reset();
  silent_since_.reset();
  after_.reset();
  in_sync_ = lost_by_silence_ = false;
}

void SyncJudge::observe(Nanoseconds time, Nanoseconds error) {
  if (time - start_ < delay_) return;
  silent_since_.reset();
  if (std::abs(error) > limit_) {
    endure(bad_since_, time);
    return;
  }
  bad_since_.reset();
  if (!good_since_) good_since_ = time;
  if (!in_sync_ && time - *good_since_ >= settle_) {
    in_sync_ = true;
    if (!after_) after_ = time - start_;
  }
}

void SyncJudge::observe_silence(Nanoseconds time) {
  if (time - start_ >= delay_) endure(silent_since_, time);
}

void SyncJudge::lose() {
  in_sync_ = lost_by_silence_ = false;
  good_since_.reset();
}

/// Before the lock a violation starts the settle time again, afterwards only one that lasts takes it.
void SyncJudge::endure(std::optional<Nanoseconds>& since, Nanoseconds time) {
  if (!since) since = time;
  // A single lost frame says nothing about the error, in sync or not.
  const bool silent = &since == &silent_since_;
  if ((in_sync_ || silent) && time - *since < kPatience) return;
  const bool by_silence = silent && (in_sync_ || lost_by_silence_);
  lose();
  lost_by_silence_ = by_silence;
}

}  // namespace syncline::dc
