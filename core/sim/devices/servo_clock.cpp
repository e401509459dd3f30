// SPDX-License-Identifier: Apache-2.0
#include "sim/devices/servo_clock.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace syncline::sim {
namespace {

constexpr double kLargestStep = 1000;  // ns a SYNC0
constexpr double kProportional = 0.25, kIntegral = 0.02;
constexpr double kLargestTrim = 500e-6;
constexpr Nanoseconds kLockWindow = 1000, kUnlockWindow = 3000;

}  // namespace

ServoClock::ServoClock(Nanoseconds period, double ppm, Nanoseconds phase)
    : period_(period), quartz_(1 / (1 + ppm * 1e-6)), phase_(phase % period) {
  set_length();
}

void ServoClock::set_length() { length_ = std::llround(static_cast<double>(period_) * (quartz_ + trim_) * kOne); }

void ServoClock::pass(std::int64_t length) {
  const auto sum = static_cast<std::int64_t>(fraction_) + length;
  next_ = *next_ + (sum >> kFractionBits);
  fraction_ = static_cast<std::uint32_t>(sum);
}

std::optional<Nanoseconds> ServoClock::take_before(Nanoseconds time) {
  if (!next_) next_ = time - time % period_ + phase_;
  if (*next_ >= time) return std::nullopt;
  const auto tick = *next_;
  pass(length_);
  return tick;
}

bool ServoClock::skip_before(Nanoseconds time) {
  if (!next_) next_ = time - time % period_ + phase_;
  if (*next_ >= time) return false;
  constexpr Nanoseconds kShort = Nanoseconds{1} << 30;
  if (time - *next_ < kShort) {  // which divides much faster
    const auto short_distance = (time - *next_) * kOne - fraction_;
    pass((short_distance + length_ - 1) / length_ * length_);
    return true;
  }
  __extension__ using Wide = __int128;
  const auto distance = static_cast<Wide>(time - *next_) * kOne - fraction_;
  const auto periods = (distance + length_ - 1) / length_;
  const auto sum = fraction_ + periods * length_;
  next_ = *next_ + static_cast<Nanoseconds>(sum >> kFractionBits);
  fraction_ = static_cast<std::uint32_t>(sum);
  return true;
}

void ServoClock::restart(Nanoseconds sync0) {
  phase_error_ = next_ ? *next_ - sync0 : 0;
  if (phase_error_ > period_ / 2) phase_error_ -= period_;
  next_ = sync0;
  fraction_ = 0;
  good_ = kGoodToLock;
}

void ServoClock::follow(Nanoseconds sync0, Nanoseconds grid) {
  if (!next_) next_ = sync0 + phase_;
  auto error = (*next_ - sync0) % grid;
  if (error > grid / 2) error -= grid;
  if (error <= -grid / 2) error += grid;
  phase_error_ = error;
  const auto magnitude = std::abs(error);
  if (magnitude > (locked() ? kUnlockWindow : kLockWindow)) {
    good_ = 0;
  } else if (!locked()) {
    ++good_;
  }
  const double step = std::clamp(static_cast<double>(error) * kProportional, -kLargestStep, kLargestStep);
  next_ = *next_ - static_cast<Nanoseconds>(std::lround(step));
  // The frequency is learned near the goal only: on the long way there the error says nothing about it.
  if (magnitude < 4 * kUnlockWindow) {
    trim_ = std::clamp(trim_ - kIntegral * static_cast<double>(error) / static_cast<double>(4 * period_), -kLargestTrim,
                       kLargestTrim);
    set_length();
  }
}

void ServoClock::release() {
  good_ = 0;
  trim_ = 0;
  set_length();
}

}  // namespace syncline::sim
