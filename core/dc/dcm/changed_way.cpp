// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/changed_way.h"

#include <algorithm>
#include <cmath>

namespace syncline::dc {
namespace {

/// Of the cycle: a hundred slaves make a way longer by some 30 us. What is more is no way.
constexpr Nanoseconds kMostShare = 20;
/// Slaves follow another rate some cycles behind, the longer these are.
constexpr double kLedBackPpm = 2;
constexpr double kLongCycle = 1e6;  // ns

}  // namespace

ChangedWay::ChangedWay(Nanoseconds cycle, Nanoseconds least)
    : most_(cycle / kMostShare),
      least_(least),
      step_(kLedBackPpm * 1e-6 * std::min(static_cast<double>(cycle), kLongCycle)) {}

void ChangedWay::start() {
  offset_ = before_ = 0;
  taken_ = kReadings;
}

void ChangedWay::note() {
  before_ = offset_;
  taken_ = 0;
}

bool ChangedWay::take(Nanoseconds off) {
  if (taken_ == kReadings) {
    lead_back();
    return false;
  }
  off_[taken_++] = off;
  const double seen = static_cast<double>(median()), size = std::abs(seen - before_);
  const bool another = size > static_cast<double>(least_) && size <= static_cast<double>(most_);
  offset_ = another ? seen : before_;
  return another && taken_ == 1;
}

void ChangedWay::lead_back() { offset_ -= std::clamp(offset_, -step_, step_); }

Nanoseconds ChangedWay::offset() const { return std::llround(offset_); }

Nanoseconds ChangedWay::median() const {
  auto sorted = off_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((taken_ - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(taken_));
  return *middle;
}

}  // namespace syncline::dc
