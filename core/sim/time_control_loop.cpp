// SPDX-License-Identifier: Apache-2.0
#include "sim/time_control_loop.h"

#include <algorithm>
#include <array>

#include "protocol/dc_registers.h"

namespace syncline::sim {
namespace {
/// Counts of the speed counter per nanosecond of mean difference: the one free constant of the model.
constexpr double kGain = 1.0;
constexpr std::int32_t kCounterMargin = 0x7F;

/// Weight of a new value in a filter of depth 2^exponent.
double share(std::uint8_t exponent) {
  static constexpr auto kShares = [] {
    std::array<double, 16> shares{};
    for (unsigned i = 0; i < shares.size(); ++i) shares[i] = 1.0 / static_cast<double>(1U << i);
    return shares;
  }();
  return kShares[exponent];
}
}  // namespace

void TimeControlLoop::observe(std::int32_t local_minus_received) {
  mean_ += (local_minus_received - mean_) * share(difference_depth_);
  const double limit = start_ - kCounterMargin;
  const double wanted = std::clamp(period_deviation_ + kGain * mean_, -limit, limit);
  period_deviation_ += (wanted - period_deviation_) * share(speed_depth_);
  diff_ = static_cast<std::int32_t>(wanted < 0 ? wanted - 0.5 : wanted + 0.5);
}

void TimeControlLoop::set_speed_counter_start(std::uint16_t value) {
  start_ = std::clamp<std::uint16_t>(value & 0x7FFF, kMinSpeedCounterStart, kMaxSpeedCounterStart);
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
  return SystemTimeDifference::from_signed(static_cast<std::int64_t>(mean_ < 0 ? mean_ - 0.5 : mean_ + 0.5)).raw;
}

double TimeControlLoop::correction() const { return speed_counter_rate(start_, diff_); }

}  // namespace syncline::sim
