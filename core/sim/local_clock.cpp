// SPDX-License-Identifier: Apache-2.0
#include "sim/local_clock.h"

#include <algorithm>
#include <cmath>

namespace syncline::sim {
namespace {
constexpr Nanoseconds kWanderStep = 100 * kMillisecond;
/// Standard deviation of one wander step, relative to the limit: the whole range takes some 10 s.
constexpr double kWanderStepShare = 0.1;
}  // namespace

LocalClock::LocalClock(const OscillatorConfig& config, Nanoseconds power_on, std::uint64_t seed)
    : time_(power_on),
      raw_(static_cast<std::uint64_t>(config.start_offset)),
      ppm_(config.ppm),
      wander_limit_(std::abs(config.wander_ppm)),
      next_wander_(wander_limit_ > 0 ? power_on + kWanderStep : INT64_MAX),
      random_(seed) {}

void LocalClock::wander_to(Nanoseconds time) {
  while (next_wander_ <= time) {
    commit(next_wander_);
    wander_ = std::clamp(wander_ + kWanderStepShare * wander_limit_ * random_.normal(), -wander_limit_, wander_limit_);
    next_wander_ += kWanderStep;
  }
}

Nanoseconds LocalClock::time_of(std::uint64_t local) const {
  const double missing = static_cast<double>(static_cast<std::int64_t>(local - raw_)) - (raw_fraction_ - correction_);
  if (missing <= 0) return time_;
  // 2 - rate is below 1 / rate and spares a division; what it lacks is a fraction of a nanosecond for every millisecond.
  const double rate = (1 + ppm() * 1e-6) * (1 - correction_rate_);
  auto time = time_ - whole(-missing * (2 - rate));
  while (static_cast<std::int64_t>(local - exact(time)) > 0) ++time;
  return time;
}

}  // namespace syncline::sim
