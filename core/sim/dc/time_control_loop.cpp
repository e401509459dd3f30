// SPDX-License-Identifier: Apache-2.0
#include "sim/dc/time_control_loop.h"

#include <algorithm>
#include <utility>

#include "protocol/speed_counter.h"
#include "protocol/system_time_difference.h"

namespace syncline::sim {
namespace {
/// To the nearest whole number.
std::int64_t rounded(std::int64_t value) {
  constexpr std::int64_t kHalf = std::int64_t{1} << (TimeControlLoop::kFractionBits - 1);
  return (value + kHalf) >> TimeControlLoop::kFractionBits;
}
}  // namespace

bool TimeControlLoop::observe(std::int32_t local_minus_received) {
  mean_ += (fixed(local_minus_received) - mean_) >> difference_depth_;
  // One count of the speed counter for each nanosecond of mean difference: the one free constant of the model.
  const auto wanted = std::max(std::min(period_deviation_ + mean_, limit_), -limit_);
  period_deviation_ += (wanted - period_deviation_) >> speed_depth_;
  const auto diff = static_cast<std::int32_t>(rounded(wanted));
  return std::exchange(diff_, diff) != diff;
}

void TimeControlLoop::set_speed_counter_start(std::uint16_t value) {
  start_ = std::clamp<std::uint16_t>(value & 0x7FFF, kMinSpeedCounterStart, kMaxSpeedCounterStart);
  limit_ = limit_of(start_);
  mean_ = 0;
  period_deviation_ = 0;
  diff_ = 0;
}

void TimeControlLoop::set_filter_depth_difference(std::uint8_t exponent) {
  difference_depth_ = exponent & 0x0F;
  mean_ = 0;
}

void TimeControlLoop::set_filter_depth_speed_counter(std::uint8_t exponent) {
  speed_depth_ = exponent & 0x0F;
  period_deviation_ = 0;
  diff_ = 0;
}

std::uint32_t TimeControlLoop::system_time_difference() const {
  return SystemTimeDifference::from_signed(rounded(mean_)).raw;
}

double TimeControlLoop::correction() const { return speed_counter_rate(start_, diff_); }

}  // namespace syncline::sim
