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
      next_wander_(power_on + kWanderStep),
      random_(seed) {}

double LocalClock::raw_gain(Nanoseconds time) const {
  return raw_fraction_ + static_cast<double>(time - time_) * ppm() * 1e-6;
}

double LocalClock::correction(Nanoseconds time) const {
  return correction_ + static_cast<double>(time - time_) * (1 + ppm() * 1e-6) * correction_rate_;
}

void LocalClock::commit(Nanoseconds time) {
  const double gain = raw_gain(time);
  const double whole = std::floor(gain);
  correction_ = correction(time);
  raw_ += static_cast<std::uint64_t>(time - time_) + static_cast<std::uint64_t>(static_cast<std::int64_t>(whole));
  raw_fraction_ = gain - whole;
  time_ = time;
}

void LocalClock::advance_to(Nanoseconds time) {
  if (time <= time_) {
    return;
  }
  if (wander_limit_ > 0) {
    while (next_wander_ <= time) {
      commit(next_wander_);
      wander_ = std::clamp(wander_ + kWanderStepShare * wander_limit_ * random_.normal(), -wander_limit_,
                           wander_limit_);
      next_wander_ += kWanderStep;
    }
  }
  commit(time);
}

std::uint64_t LocalClock::sample(Nanoseconds time) const {
  const auto gain = static_cast<std::int64_t>(std::floor(raw_gain(time)));
  const std::uint64_t raw = raw_ + static_cast<std::uint64_t>(time - time_ + gain);
  return raw - raw % kTick - static_cast<std::uint64_t>(std::llround(correction(time)));
}

std::uint64_t LocalClock::exact(Nanoseconds time) const {
  const auto gain = static_cast<std::int64_t>(std::floor(raw_gain(time) - correction(time)));
  return raw_ + static_cast<std::uint64_t>(time - time_ + gain);
}

Nanoseconds LocalClock::time_of(std::uint64_t local) const {
  const auto missing = static_cast<std::int64_t>(local - exact(time_));
  if (missing <= 0) {
    return time_;
  }
  const double rate = (1 + ppm() * 1e-6) * (1 - correction_rate_);
  auto time = time_ + static_cast<Nanoseconds>(std::floor(static_cast<double>(missing) / rate));
  while (static_cast<std::int64_t>(local - exact(time)) > 0) {
    ++time;
  }
  return time;
}

}  // namespace syncline::sim
