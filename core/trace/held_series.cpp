// SPDX-License-Identifier: Apache-2.0
#include "trace/held_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace syncline {

void HeldSeries::hear(Nanoseconds time, float value) {
  if (!series_.empty() && time <= heard_) return;
  measure(time);
  if (!known_ || value != value_) series_.append(time, value);
  heard_ = time;
  value_ = value;
  known_ = true;
}

void HeldSeries::measure(Nanoseconds time) {
  const bool seldom = !known_ && expired_;
  const auto before = std::exchange(seldom_, seldom ? time - heard_ : 0);
  if (!known_ && !seldom) return;
  interval_ = time - heard_;
  // Of a time when everybody waited for one slow mailbox it is not read more seldom for ever.
  constexpr Nanoseconds kForget = 16;
  longest_ = std::max(longest_ - longest_ / kForget, seldom ? std::min(before, interval_) : interval_);
}

void HeldSeries::hear(std::span<const Nanoseconds> times, std::span<const float> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) {
      lose(times[i]);
    } else {
      hear(times[i], values[i]);
    }
  }
}

bool HeldSeries::change(Nanoseconds time, float value) {
  if (!series_.empty() && time < series_.last_time()) return false;
  if (!known_ || value != value_) series_.append(time, value);
  heard_ = std::max(heard_, time);
  value_ = value;
  known_ = true;
  return true;
}

void HeldSeries::lose(Nanoseconds time) {
  expired_ = false;
  if (!known_) return;
  known_ = false;
  heard_ = std::max(heard_ + 1, time);
  series_.append(heard_, std::numeric_limits<float>::quiet_NaN());
}

void HeldSeries::expire(Nanoseconds now) {
  if (known_ && now - heard_ > std::max(kPatience, 4 * longest_)) {
    lose(heard_);
    expired_ = true;
  }
}

void HeldSeries::clear() {
  series_.clear();
  heard_ = longest_ = interval_ = seldom_ = 0;
  known_ = expired_ = false;
  shown_until_ = INT64_MAX;
}

void HeldSeries::show_until(Nanoseconds time) {
  series_.show_until(time);
  shown_until_ = time;
}

Nanoseconds HeldSeries::heard() const {
  if (shown_until_ >= heard_) return heard_;
  if (series_.empty()) return 0;
  return series_.held_at(shown_until_) ? shown_until_ : series_.last_time();
}

std::optional<MinMaxSeries::Reading> HeldSeries::at(Nanoseconds time) const {
  // Behind the last reading it is the last one that is old, not another one that holds.
  return series_.held_at(time);
}

}  // namespace syncline
