// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/slow_range.h"

#include <algorithm>
#include <cmath>

#include "ui/plots/round_step.h"

namespace syncline::ui {
namespace {

constexpr double kTicks = 5;        // about as many lines
constexpr double kRounding = 8;     // the range's ends are round to this part of it
constexpr double kFarFromZero = 3;  // data this many times their span away from zero are shown without it
constexpr double kHeadroom = 0.06;  // of the data's span, above and below
constexpr double kRoomy = 0.55;     // data that need less of the range than this may shrink it

}  // namespace

SlowRange::SlowRange(double minimum_span, bool with_zero, int hold_updates)
    : minimum_span_(minimum_span), with_zero_(with_zero), hold_updates_(hold_updates), high_(minimum_span) {}

double SlowRange::step() const { return roundStep((high_ - low_) / kTicks); }

bool SlowRange::update(double low, double high) {
  if (fixed_ || low > high) return false;
  const bool with_zero = with_zero_ && low <= kFarFromZero * (high - low + minimum_span_);
  const double room = (high - low) * kHeadroom;
  low -= low < 0 || !with_zero ? room : 0;
  high += room;
  if (with_zero) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
  }
  if (high - low < minimum_span_) {
    const double missing = minimum_span_ - (high - low);
    const bool from_zero = with_zero && low >= 0;
    low -= from_zero ? 0 : missing / 2;
    high += from_zero ? missing : missing / 2;
  }
  const double old_low = low_;
  const double old_high = high_;
  const bool roomy = high - low < kRoomy * (high_ - low_);
  roomy_updates_ = roomy ? roomy_updates_ + 1 : 0;
  if (fit_next_ || roomy_updates_ > hold_updates_) {
    take(low, high);
  } else if (low < low_ || high > high_) {
    take(std::min(low, low_), std::max(high, high_));
  }
  return low_ != old_low || high_ != old_high;
}

void SlowRange::fit() {
  fixed_ = false;
  fit_next_ = true;
}

void SlowRange::fix(double low, double high) {
  if (!(high > low)) return;
  fixed_ = true;
  low_ = low;
  high_ = high;
}

void SlowRange::take(double low, double high) {
  const double step = roundStep((high - low) / kRounding);
  low_ = std::floor(low / step + 1e-9) * step;
  high_ = std::ceil(high / step - 1e-9) * step;
  fit_next_ = false;
  roomy_updates_ = 0;
}

}  // namespace syncline::ui
