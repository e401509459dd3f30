// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/local_clock.h"

#include <algorithm>
#include <cmath>

namespace syncline::sim {
namespace {

constexpr Nanoseconds kStep = 100 * kMillisecond;
/// So many steps at once at most: an hour. When more time passes without a frame, the steps are longer.
constexpr Nanoseconds kMostSteps = 36'000;
/// Standard deviation of one wander step, relative to the limit: the whole range takes some 10 s.
constexpr double kWanderStepShare = 0.1;
constexpr double kLargestRate = 0.1;

/// Sum of a time and a duration of at least 0; the end of time when it lies behind.
Nanoseconds later(Nanoseconds time, Nanoseconds by) { return time > INT64_MAX - by ? LocalClock::kNever : time + by; }

}  // namespace

LocalClock::LocalClock(const OscillatorConfig& config, Nanoseconds power_on, std::uint64_t seed)
    : ppm_(config.ppm),
      wander_limit_(std::abs(config.wander_ppm)),
      changes_(config.changes),
      random_(seed),
      next_wander_(wander_limit_ > 0 ? later(power_on, kStep) : kNever),
      next_move_(next_move(power_on, kStep)),
      next_change_(std::min(next_wander_, next_move_)),
      raw_time_(power_on),
      correction_time_(power_on),
      raw_(static_cast<Fixed>(static_cast<std::uint64_t>(config.start_offset)) * kOne) {
  moved_ = moved_at(power_on);
  take_rates();
}

std::int64_t LocalClock::rate_of(double relative) {
  const double held = relative == relative ? std::clamp(relative, -kLargestRate, kLargestRate) : 0;
  return static_cast<std::int64_t>(held * static_cast<double>(kOne));
}

void LocalClock::take_rates() {
  raw_rate_ = kOne + rate_of((ppm_ + wander_ + moved_) * 1e-6);
  correction_rate_ = by_quartz(loop_rate_);
}

void LocalClock::change_until(Nanoseconds time) {
  const auto step = std::max(kStep, (time - next_change_) / kMostSteps);
  while (next_change_ <= time) {
    commit(next_change_);
    if (next_change_ == next_wander_) {
      wander_ =
          std::clamp(wander_ + kWanderStepShare * wander_limit_ * random_.normal(), -wander_limit_, wander_limit_);
      next_wander_ = later(next_wander_, step);
    }
    if (next_change_ == next_move_) {
      moved_ = moved_at(next_move_);
      next_move_ = next_move(next_move_, step);
    }
    next_change_ = std::min(next_wander_, next_move_);
    take_rates();
    if (next_change_ == kNever) break;
  }
}

double LocalClock::moved_at(Nanoseconds time) const {
  double ppm = 0;
  for (const auto& change : changes_) {
    if (time < change.begin) continue;
    const bool over = time >= change.end;
    ppm += over
               ? change.ppm
               : change.ppm * static_cast<double>(time - change.begin) / static_cast<double>(change.end - change.begin);
  }
  return ppm;
}

Nanoseconds LocalClock::next_move(Nanoseconds time, Nanoseconds step) const {
  Nanoseconds next = kNever;
  for (const auto& change : changes_) {
    if (time < change.begin) {
      next = std::min(next, change.begin);
    } else if (time < change.end) {
      next = std::min(next, std::min(change.end, later(time, step)));
    }
  }
  return next;
}

Nanoseconds LocalClock::time_before(const Moment& moment, std::uint64_t local) {
  const auto since = static_cast<Fixed>(moment.exact() - local) * kOne + (moment.shown & (kOne - 1));
  return moment.time - static_cast<Nanoseconds>(since / moment.rate);
}

/// In true time, until the counter has gone on by `ahead` less `fraction`.
LocalClock::Unsigned LocalClock::passing_time(std::uint64_t ahead, std::uint64_t fraction) const {
  constexpr std::uint64_t kShort = std::uint64_t{1} << 24;  // ns
  constexpr std::int64_t kSmall = kOne >> 10;
  const auto missing = static_cast<Unsigned>(ahead) * static_cast<std::uint64_t>(kOne) - fraction;
  const auto rate = static_cast<std::uint64_t>(raw_rate_ - correction_rate_);
  const auto deviation = raw_rate_ - correction_rate_ - kOne;
  if (ahead >= kShort || deviation > kSmall || deviation < -kSmall) return (missing + rate - 1) / rate;
  // A quartz is so good that the first guess is nearly right, and multiplying is much faster than dividing.
  auto passed = ahead - static_cast<std::uint64_t>(static_cast<Fixed>(ahead) * deviation >> kFractionBits);
  auto reached = static_cast<Unsigned>(passed) * rate;
  for (; reached < missing; ++passed) reached += rate;
  for (; reached - rate >= missing; --passed) reached -= rate;
  return passed;
}

Nanoseconds LocalClock::time_of(std::uint64_t local, Nanoseconds from) const {
  const auto shown = raw_at(from) - correction_at(from);
  // A counter that wraps: what is further ahead than half of its range is past.
  const auto ahead = static_cast<std::int64_t>(local - whole(shown));
  if (ahead <= 0) return from;
  const auto passed = passing_time(static_cast<std::uint64_t>(ahead), static_cast<std::uint64_t>(shown & (kOne - 1)));
  return passed >= static_cast<std::uint64_t>(kNever - from) ? kNever : from + static_cast<Nanoseconds>(passed);
}

}  // namespace syncline::sim
