// SPDX-License-Identifier: Apache-2.0
#include "trace/reference_times.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "channels/cycle_sample.h"

namespace syncline {

void ReferenceTimes::add(std::span<const CycleSample> samples) {
  for (const auto& sample : samples) {
    if ((sample.flags & CycleSample::kReferenceValid) == 0 || sample.reference_time == 0) continue;
    Reading reading{sample.send_time, static_cast<Nanoseconds>(sample.reference_time), false};
    if (newest_ && reading.host <= newest_->host) continue;
    if (newest_) {
      const auto change = (reading.reference - reading.host) - (newest_->reference - newest_->host);
      reading.steps = std::llabs(change) > kStep;
    }
    if (reading.steps && readings_.back().host != newest_->host) readings_.push_back(*newest_);
    if (readings_.empty() || reading.steps || reading.host - readings_.back().host >= kApart)
      readings_.push_back(reading);
    newest_ = reading;
    newest_->steps = false;
    while (readings_.size() > kMost) readings_.pop_front();
  }
}

std::optional<Nanoseconds> ReferenceTimes::at(Nanoseconds host) const {
  if (readings_.empty() || host < readings_.front().host) return std::nullopt;
  const auto after = std::ranges::upper_bound(readings_, host, {}, &Reading::host);
  const auto& before = *std::prev(after);
  const auto along = [host](const Reading& from, const Reading& to) {
    if (to.host == from.host) return from.reference;
    const double part = static_cast<double>(host - from.host) / static_cast<double>(to.host - from.host);
    return from.reference +
           static_cast<Nanoseconds>(std::llround(part * static_cast<double>(to.reference - from.reference)));
  };
  if (after != readings_.end()) {
    if (!after->steps && after->host - before.host <= kReach) return along(before, *after);
  } else if (host <= newest_->host) {
    return along(before, *newest_);
  }
  // On from the last reading at the host's rate.
  const auto& last = after == readings_.end() ? *newest_ : before;
  if (host - last.host > kReach) return std::nullopt;
  return last.reference + (host - last.host);
}

}  // namespace syncline
