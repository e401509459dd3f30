// SPDX-License-Identifier: Apache-2.0
#include "trace/held_frames.h"

namespace syncline {

bool HeldFrames::note(Nanoseconds time, Nanoseconds by) {
  if (by < kRemarkable) {
    in_a_row_ = 0;
    not_sure_ = 0;
    return false;
  }
  not_sure_ += by;
  if (++in_a_row_ < kInARow && by < kBeyondStamps) return false;
  add(time, not_sure_);
  not_sure_ = 0;
  return true;
}

void HeldFrames::add(Nanoseconds time, Nanoseconds by) {
  if (spans_[latest_].sum == 0 || time - spans_[latest_].begin >= kSpan) {
    latest_ = (latest_ + 1) % spans_.size();
    spans_[latest_] = {time, 0};
  }
  spans_[latest_].sum += by;
}

Nanoseconds HeldFrames::sum(Nanoseconds from, Nanoseconds to) const {
  Nanoseconds sum = 0;
  for (const auto& span : spans_) {
    if (span.sum > 0 && span.begin >= from && span.begin <= to) sum += span.sum;
  }
  return sum;
}

}  // namespace syncline
