// SPDX-License-Identifier: Apache-2.0
#include "support/calendar_stamp.h"

#include <time.h>

#include <cstdlib>

namespace syncline {
namespace {

constexpr int kTries = 32;
/// Further from each other than this the difference is another one; a reading that took longer proves nothing.
constexpr Nanoseconds kChange = 2 * kMicrosecond, kQuick = 1 * kMicrosecond;
/// Rounding of the kernel's clocks against each other.
constexpr Nanoseconds kTolerance = 200;

Nanoseconds calendar_now() {
  timespec time{};
  ::clock_gettime(CLOCK_REALTIME, &time);
  return static_cast<Nanoseconds>(time.tv_sec) * kSecond + time.tv_nsec;
}

}  // namespace

CalendarStamp::CalendarStamp(const Clock& clock) : clock_(clock) {
  auto best = read();
  for (int i = 1; i < kTries; ++i) {
    const auto pair = read();
    if (pair.way < best.way) best = pair;
  }
  ahead_ = best.ahead;
}

CalendarStamp::Pair CalendarStamp::read() const {
  const auto before = clock_.now();
  const auto calendar = calendar_now();
  const auto after = clock_.now();
  return {calendar - (before + (after - before) / 2), after - before, after};
}

std::optional<Nanoseconds> CalendarStamp::to_clock(Nanoseconds calendar, Nanoseconds earliest) {
  const auto pair = read();
  if (std::abs(pair.ahead - ahead_) > kChange && pair.way <= kQuick) ahead_ = pair.ahead;
  const auto time = calendar - ahead_;
  if (time < earliest - kTolerance || time > pair.now + kTolerance) return std::nullopt;
  return time;
}

}  // namespace syncline
