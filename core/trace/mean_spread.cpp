// SPDX-License-Identifier: Apache-2.0
#include "trace/mean_spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "support/confidence.h"

namespace syncline {
namespace {

/// The most by which rounding to whole numbers moves the mean of values that deviate by so much: the harmonics of the
/// sawtooth that rounding is, as far as the deviation leaves them. Half of a unit for values that do not deviate.
double moved_by_rounding(double deviation) {
  const double variance = std::max(deviation * deviation - 1.0 / 12, 0.0);  // without rounding's own
  double moved = 0;
  for (int harmonic = 1; harmonic <= 3; ++harmonic) {
    const double turn = 2 * std::numbers::pi * std::numbers::pi * harmonic * harmonic;
    moved += std::exp(-turn * variance) / (std::numbers::pi * harmonic);
  }
  return std::min(moved, 0.5);
}

}  // namespace

void MeanSpread::close() {
  sums_[batches_++] = open_;
  open_ = 0;
  in_open_ = 0;
  if (batches_ < kMost) return;
  for (std::size_t i = 0; i < kMost / 2; ++i) sums_[i] = sums_[2 * i] + sums_[2 * i + 1];
  batches_ = kMost / 2;
  size_ *= 2;
}

std::optional<Interval> MeanSpread::interval(double deviation) const {
  const auto of_sums = mean_interval(std::span(sums_).first(batches_));
  if (!of_sums) return std::nullopt;
  const auto size = static_cast<double>(size_);
  const double moved = whole_ ? moved_by_rounding(deviation) : 0;
  return Interval{of_sums->low / size - moved, of_sums->high / size + moved};
}

}  // namespace syncline
