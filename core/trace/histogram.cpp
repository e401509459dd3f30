// SPDX-License-Identifier: Apache-2.0
#include "trace/histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace syncline {
namespace {

constexpr unsigned kSubBits = 5;  // 32 bins a power of two
constexpr std::uint64_t kSub = 1U << kSubBits;

std::size_t bin_of(std::uint64_t value) {
  if (value < kSub) return static_cast<std::size_t>(value);
  const auto exponent = static_cast<unsigned>(std::bit_width(value)) - 1 - kSubBits;
  return static_cast<std::size_t>((exponent + 1) * kSub + ((value >> exponent) - kSub));
}

std::uint64_t low_edge(std::size_t bin) {
  if (bin < kSub) return bin;
  const auto exponent = bin / kSub - 1;
  return (kSub + bin % kSub) << exponent;
}

}  // namespace

Histogram::Histogram() : counts_((64 - kSubBits) * kSub) {}

void Histogram::add(std::int64_t value) {
  value = std::max<std::int64_t>(value, 0);
  min_ = count_ == 0 ? value : std::min(min_, value);
  max_ = count_ == 0 ? value : std::max(max_, value);
  ++counts_[bin_of(static_cast<std::uint64_t>(value))];
  ++count_;
}

void Histogram::clear() {
  std::fill(counts_.begin(), counts_.end(), 0);
  count_ = 0;
  min_ = max_ = 0;
}

std::int64_t Histogram::percentile(double fraction) const {
  if (count_ == 0) return 0;
  const auto wanted =
      std::max<std::uint64_t>(static_cast<std::uint64_t>(std::ceil(fraction * static_cast<double>(count_))), 1);
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    seen += counts_[bin];
    if (seen >= wanted) return std::clamp(static_cast<std::int64_t>(low_edge(bin + 1) - 1), min_, max_);
  }
  return max_;
}

std::vector<Histogram::Bin> Histogram::bins() const {
  std::vector<Bin> used;
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    if (counts_[bin] == 0) continue;
    used.push_back(
        {static_cast<std::int64_t>(low_edge(bin)), static_cast<std::int64_t>(low_edge(bin + 1)), counts_[bin]});
  }
  return used;
}

}  // namespace syncline
