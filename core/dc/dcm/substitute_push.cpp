// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/substitute_push.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

/// Readings of which the average is; the loop of a clock that follows has the same share in cycles of any length
/// (speed_counter_start()), and so this one is counted in cycles, too.
constexpr int kAveraged = 16;
/// Of the average at once, so that the two loops, its average of 64 messages and its 256 of the quartz do not swing
/// together.
constexpr double kShare = 0.05;
/// They stay behind a clock by as much as it is pushed, ns.
constexpr double kMostPush = 30;

}  // namespace

void SubstitutePush::start() {
  forecast_.start();
  lag_ = 0;
  readings_ = 0;
}

bool SubstitutePush::take(const DcmObservation& observation, Nanoseconds lag) {
  const double surprise = static_cast<double>(lag) - lag_;
  const bool far = forecast_.take(observation, surprise, readings_ == kAveraged) == OutlierGate::Verdict::kOutlier;
  if (far) return true;
  readings_ = std::min(readings_ + 1, kAveraged);
  lag_ += surprise / readings_;
  return false;
}

bool SubstitutePush::take_again(const DcmObservation& observation, Nanoseconds lag) {
  return forecast_.take_again(observation, static_cast<double>(lag) - lag_);
}

std::optional<Nanoseconds> SubstitutePush::told_at(Nanoseconds stamp) const {
  auto told = forecast_.at(stamp);
  if (told) *told -= std::llround(std::clamp(kShare * lag_, -kMostPush, kMostPush));
  return told;
}

}  // namespace syncline::dc
