// SPDX-License-Identifier: Apache-2.0
#include "dc/sync_window_monitor.h"

#include "protocol/dc_registers.h"

namespace syncline::dc {

SyncWindowMonitor::SyncWindowMonitor(const SyncWindowSettings& settings, bool monitored, Nanoseconds start)
    : state_(monitored ? State::kSettling : State::kNotMonitored),
      limit_ns_(sync_window_limit_ns(settings.exponent)),
      settle_ns_(settings.settle_time_ms * kMillisecond),
      start_(start) {}

SyncWindowMonitor::Edge SyncWindowMonitor::observe(Nanoseconds time, std::uint32_t ored_magnitude_ns) {
  if (state_ == State::kNotMonitored) return Edge::kNone;
  if (ored_magnitude_ns > limit_ns_) {
    good_since_.reset();
    if (state_ != State::kInSync) return Edge::kNone;
    state_ = State::kOutOfSync;
    return Edge::kOutOfSync;
  }
  if (!good_since_) good_since_ = time;
  if (state_ == State::kInSync || time - *good_since_ < settle_ns_) return Edge::kNone;
  state_ = State::kInSync;
  settled_after_ = *good_since_ - start_;
  return Edge::kInSync;
}

}  // namespace syncline::dc
