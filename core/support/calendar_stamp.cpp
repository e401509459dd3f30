// SPDX-License-Identifier: Apache-2.0
#include "support/calendar_stamp.h"

#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "support/clock.h"

namespace syncline {
namespace {

constexpr int kTries = 32;
/// Further from each other than this the difference is another one, beside what an interrupted reading may be off; one
/// that took longer does not say which.
constexpr Nanoseconds kChange = 2 * kMicrosecond, kQuick = 1 * kMicrosecond;
/// Rounding of the kernel's clocks against each other.
constexpr Nanoseconds kTolerance = 200;
/// So long after the calendar was set frames that were stamped before may still be read.
constexpr Nanoseconds kMemory = 2 * kSecond;
/// No frame waits for longer in the kernel's ring.
constexpr Nanoseconds kOldest = kSecond;
/// By so much two processors that receive may change the order.
constexpr Nanoseconds kOrder = 100 * kMicrosecond;

}  // namespace

Nanoseconds calendar_now() {
  timespec time{};
  ::clock_gettime(CLOCK_REALTIME, &time);
  return static_cast<Nanoseconds>(time.tv_sec) * kSecond + time.tv_nsec;
}

CalendarStamp::CalendarStamp(const Clock& clock, Calendar calendar) : clock_(clock), calendar_(std::move(calendar)) {
  auto best = read();
  for (int i = 1; i < kTries; ++i) {
    const auto pair = read();
    if (pair.way < best.way) best = pair;
  }
  ahead_ = best.ahead;
  confirmed_ = best.now;
}

CalendarStamp::Pair CalendarStamp::read() const {
  const auto before = clock_.now();
  const auto calendar = calendar_();
  const auto after = clock_.now();
  return {calendar - (before + (after - before) / 2), after - before, after};
}

bool CalendarStamp::notice(const Pair& pair) {
  if (last_ && pair.now - last_->end > kMemory) last_.reset();
  const auto change = std::abs(pair.ahead - ahead_);
  if (change > kChange && pair.way > kQuick) return change <= kChange + pair.way / 2;
  if (change > kChange) {
    last_ = {ahead_, confirmed_, pair.now};
    ahead_ = pair.ahead;
  }
  confirmed_ = pair.now;
  return true;
}

std::optional<Nanoseconds> CalendarStamp::to_clock(Nanoseconds calendar, Nanoseconds earliest) {
  const auto pair = read();
  if (!notice(pair)) return std::nullopt;
  const auto within = [&](Nanoseconds ahead, Nanoseconds begin, Nanoseconds end) -> std::optional<Nanoseconds> {
    const auto time = calendar - ahead;
    if (time < std::max(begin, earliest) - kTolerance || time > end + kTolerance) return std::nullopt;
    return time;
  };
  const auto by_new = within(ahead_, last_ ? last_->begin : earliest, pair.now);
  const auto by_old = last_ ? within(last_->ahead, earliest, last_->end) : std::nullopt;
  if (by_new && by_old) return std::nullopt;
  return by_new ? by_new : by_old;
}

Nanoseconds ArrivalStamp::to_clock(Nanoseconds calendar) {
  const auto now = clock_.now();
  const auto time = stamps_.to_clock(calendar, std::max(now - kOldest, last_ - kOrder));
  last_ = time.value_or(last_);
  return time.value_or(now);
}

}  // namespace syncline
