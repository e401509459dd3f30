// SPDX-License-Identifier: Apache-2.0
#include "link/arrival_forecast.h"

#include <algorithm>
#include <cmath>

namespace syncline {
namespace {

/// A cycle that is so far off, as a part of its length, is another cycle.
constexpr double kAbout = 0.2;
constexpr double kMemory = 1.0 / 16;
constexpr unsigned kEnough = 16;  // cycles, until their distance is known
/// The window, as a part of the cycle, and its length at least: a timer wakes nobody up to the microsecond, and always
/// too late.
constexpr double kWidest = 0.1;
constexpr double kNarrowest = 14'000;  // ns
constexpr double kWakeUp = 10'000;     // ns, before it
constexpr double kSpreads = 4;         // mean distances from the place that it has room for, each way

}  // namespace

void ArrivalForecast::begin_anew(Nanoseconds period) {
  period_ = static_cast<double>(period);
  spread_ = 0;
  regular_ = 0;
}

void ArrivalForecast::arrived(Nanoseconds time) {
  const bool same_cycle = last_ && time - *last_ < kTogether;
  last_ = time;
  if (same_cycle) return;
  const auto before = cycle_begin_;
  cycle_begin_ = time;
  if (!before) return;
  const auto distance = time - *before;
  const auto off = static_cast<double>(distance) - period_;
  if (period_ <= 0 || std::abs(off) > kAbout * period_) return begin_anew(distance);
  period_ += kMemory * off;
  spread_ += kMemory * (std::abs(off) - spread_);
  regular_ = std::min(regular_ + 1, kEnough);
}

std::optional<ArrivalForecast::Window> ArrivalForecast::next() const {
  if (regular_ < kEnough || !cycle_begin_) return std::nullopt;
  const auto half = std::max(kNarrowest / 2, kSpreads * spread_);
  if (kWakeUp + 2 * half > kWidest * period_) return std::nullopt;
  const auto middle = *cycle_begin_ + static_cast<Nanoseconds>(std::llround(period_));
  const auto each = static_cast<Nanoseconds>(std::llround(half));
  return Window{middle - each - static_cast<Nanoseconds>(kWakeUp), middle + each};
}

}  // namespace syncline
