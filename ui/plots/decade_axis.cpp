// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/decade_axis.h"

#include <algorithm>
#include <cmath>

namespace syncline::ui {
namespace {

constexpr double kRoom = 0.06;  // of the decades, at each end

}  // namespace

DecadeAxis::DecadeAxis(double low, double high) {
  double from = std::log10(std::min(low, high));
  double to = std::log10(std::max(low, high));
  const double lacking = std::max(1 - (to - from), 0.0) / 2;
  from -= lacking;
  to += lacking;
  const double room = kRoom * (to - from);
  low_ = std::pow(10, from - room);
  high_ = std::pow(10, to + room);
}

double DecadeAxis::place(double value) const { return std::log10(value / low_) / std::log10(high_ / low_); }

double DecadeAxis::value(double place) const { return low_ * std::pow(high_ / low_, place); }

std::vector<DecadeAxis::Tick> DecadeAxis::ticks(int most) const {
  const auto first = static_cast<int>(std::floor(std::log10(low_)));
  const auto last = static_cast<int>(std::floor(std::log10(high_)));
  const double decades = std::log10(high_ / low_);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(most, 1))));
  const bool between = 3 * decades <= most;
  std::vector<Tick> ticks;
  for (int power = first; power <= last; ++power) {
    for (int factor = 1; factor <= 9; ++factor) {
      const double value = factor * std::pow(10, power);
      if (value < low_ || value > high_) continue;
      const bool decade = factor == 1;
      const bool labelled = decade ? power % every == 0 : between && (factor == 2 || factor == 5);
      ticks.push_back({value, decade, labelled});
    }
  }
  return ticks;
}

}  // namespace syncline::ui
