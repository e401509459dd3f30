// SPDX-License-Identifier: Apache-2.0
#include "master/cyclic/spin_budget.h"

#include <algorithm>
#include <bit>

namespace syncline {
namespace {

/// Wake-ups that are judged together. The first ones sooner, so that a long spin does not last.
constexpr std::uint32_t kSpinWindow = 500, kFirstWindow = 100;
/// Reading the clock and the way from there to the frame.
constexpr Nanoseconds kReserve = 1 * kMicrosecond;
constexpr unsigned kPerOctave = 8, kBits = 3;

/// Eight bins an octave.
std::size_t bin_of(Nanoseconds value) {
  const auto v = static_cast<std::uint64_t>(std::max<Nanoseconds>(value, 0));
  if (v < kPerOctave) return static_cast<std::size_t>(v);
  const auto octave = static_cast<unsigned>(std::bit_width(v)) - 1 - kBits;
  return (octave + 1) * kPerOctave + static_cast<std::size_t>((v >> octave) & (kPerOctave - 1));
}

Nanoseconds upper_edge(std::size_t bin) {
  if (bin < kPerOctave) return static_cast<Nanoseconds>(bin);
  const auto octave = static_cast<unsigned>(bin / kPerOctave) - 1;
  return static_cast<Nanoseconds>(((kPerOctave + bin % kPerOctave + 1) << octave) - 1);
}

}  // namespace

void SpinBudget::observe(Nanoseconds wake_late) {
  if (wake_late <= 0) return;
  ++wakes_;
  spent_ += std::max<Nanoseconds>(0, amount_ - wake_late);
  ++bins_[std::min(bin_of(wake_late), kBins - 1)];
  if (++counted_ >= (p99_ == 0 ? kFirstWindow : kSpinWindow)) adapt();
}

Nanoseconds SpinBudget::quantile(double share) const {
  const auto wanted = static_cast<std::uint32_t>(share * counted_);
  std::uint32_t seen = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    seen += bins_[bin];
    if (seen > wanted) return upper_edge(bin);
  }
  return upper_edge(kBins - 1);
}

double SpinBudget::share_within(Nanoseconds late) const {
  std::uint32_t seen = 0;
  for (std::size_t bin = 0; bin < kBins && upper_edge(bin) <= late; ++bin) seen += bins_[bin];
  return static_cast<double>(seen) / counted_;
}

/// Of those whom the longest spin would catch all but one in a hundred of all: the rest is not worth its price.
void SpinBudget::adapt() {
  p50_ = quantile(0.5);
  p99_ = quantile(0.99);
  const auto share = share_within(tolerated_ + most_ - kReserve) - 0.01;
  amount_ = share <= 0 ? 0 : std::clamp<Nanoseconds>(quantile(share) + kReserve - tolerated_, 0, most_);
  bins_.fill(0);
  counted_ = 0;
}

}  // namespace syncline
