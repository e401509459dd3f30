// SPDX-License-Identifier: Apache-2.0
#include "trace/rate_series.h"

#include <cmath>

namespace syncline {
namespace {

constexpr double kWindowSeconds = static_cast<double>(RateSeries::kWindow) / static_cast<double>(kSecond);

}  // namespace

/// What was counted a second ago counts no more, moment by moment, until before `until`.
void RateSeries::age(Nanoseconds until) {
  while (!recent_.empty() && recent_.front().time + kWindow < until) {
    const auto time = recent_.front().time + kWindow;
    while (!recent_.empty() && recent_.front().time + kWindow == time) {
      sum_ -= recent_.front().count;
      recent_.pop_front();
    }
    rates_.hear(time, static_cast<float>(sum_ / kWindowSeconds));
  }
}

void RateSeries::take(Nanoseconds time, float value) {
  age(time);
  if (std::isnan(value)) {
    recent_.clear();
    sum_ = 0;
    known_ = false;
    return rates_.lose(time);
  }
  // At this very moment, too: one value for it.
  while (!recent_.empty() && recent_.front().time + kWindow <= time) {
    sum_ -= recent_.front().count;
    recent_.pop_front();
  }
  if (known_) {
    const double counted =
        value >= last_ ? static_cast<double>(value) - static_cast<double>(last_) : static_cast<double>(value);
    sum_ += counted;
    recent_.push_back({time, counted});
  }
  known_ = true;
  last_ = value;
  rates_.hear(time, static_cast<float>(sum_ / kWindowSeconds));
}

void RateSeries::extend(const HeldSeries& count) {
  const auto& changes = count.series();
  if (changes.empty()) return;
  const auto from = done_ == INT64_MIN ? changes.first_time() : done_ + 1;
  changes.for_each(from, changes.last_time() + 1, [this](Nanoseconds time, float value) { take(time, value); });
  done_ = changes.last_time();
  if (!known_) return;
  age(count.heard() + 1);
  rates_.hear(count.heard(), static_cast<float>(sum_ / kWindowSeconds));
}

}  // namespace syncline
