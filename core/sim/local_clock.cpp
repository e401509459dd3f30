// SPDX-License-Identifier: Apache-2.0
#include "sim/local_clock.h"

#include <algorithm>
#include <cmath>

namespace syncline::sim {
namespace {
constexpr Nanoseconds kStep = 100 * kMillisecond;
/// Standard deviation of one wander step, relative to the limit: the whole range takes some 10 s.
constexpr double kWanderStepShare = 0.1;
}  // namespace

LocalClock::LocalClock(const OscillatorConfig& config, Nanoseconds power_on, std::uint64_t seed)
    : time_(power_on),
      raw_(static_cast<std::uint64_t>(config.start_offset)),
      ppm_(config.ppm),
      wander_limit_(std::abs(config.wander_ppm)),
      changes_(config.changes),
      next_wander_(wander_limit_ > 0 ? power_on + kStep : INT64_MAX),
      next_move_(next_move(power_on)),
      next_change_(std::min(next_wander_, next_move_)),
      random_(seed) {
  moved_ = moved_at(power_on);
}

void LocalClock::change_until(Nanoseconds time) {
  while (next_change_ <= time) {
    commit(next_change_);
    if (next_change_ == next_wander_) {
      wander_ = std::clamp(wander_ + kWanderStepShare * wander_limit_ * random_.normal(), -wander_limit_, wander_limit_);
      next_wander_ += kStep;
    }
    if (next_change_ == next_move_) {
      moved_ = moved_at(next_move_);
      next_move_ = next_move(next_move_);
    }
    next_change_ = std::min(next_wander_, next_move_);
  }
}

double LocalClock::moved_at(Nanoseconds time) const {
  double ppm = 0;
  for (const auto& change : changes_) {
    if (time < change.begin) continue;
    const bool over = time >= change.end;
    ppm += over ? change.ppm : change.ppm * static_cast<double>(time - change.begin) / static_cast<double>(change.end - change.begin);
  }
  return ppm;
}

Nanoseconds LocalClock::next_move(Nanoseconds time) const {
  Nanoseconds next = INT64_MAX;
  for (const auto& change : changes_) {
    if (time < change.begin) {
      next = std::min(next, change.begin);
    } else if (time < change.end) {
      next = std::min(next, std::min(change.end, time + kStep));
    }
  }
  return next;
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
