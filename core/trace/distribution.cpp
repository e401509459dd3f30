// SPDX-License-Identifier: Apache-2.0
#include "trace/distribution.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace syncline {
namespace {

constexpr unsigned kDropped = 14;  // bits of a float that are not told apart: nine of its fraction stay
constexpr std::uint32_t kSign = 0x80000000U;

/// Floats in the order of their values as unsigned numbers.
std::uint32_t ordered(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value == 0 ? 0.F : value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

float from_ordered(std::uint32_t order) { return std::bit_cast<float>((order & kSign) != 0 ? order & ~kSign : ~order); }

}  // namespace

Distribution::Distribution() : fine_(std::size_t{1} << (32 - kDropped)) {}

void Distribution::begin_anew() {
  begin_ = end_ = want_begin_;
  bins_.assign(grid_.bins, 0);
  std::ranges::fill(fine_, 0);
  below_ = above_ = count_ = 0;
}

void Distribution::aim(const MinMaxSeries* series, Nanoseconds begin, Nanoseconds end, const BinGrid& grid) {
  const bool other = series != series_ || grid != grid_ || bins_.empty();
  series_ = series;
  grid_ = grid;
  want_begin_ = begin;
  want_end_ = std::max(begin, end);
  if (series_ != nullptr && !series_->empty()) {
    // What has not come yet is counted when it has; what is no more cannot be taken away.
    want_begin_ = std::max(want_begin_, series_->first_time());
    want_end_ = std::clamp(want_end_, want_begin_, std::max(series_->last_time() + 1, want_begin_));
  } else {
    want_end_ = want_begin_;
  }
  const bool gone = series_ != nullptr && count_ > 0 && (series_->empty() || series_->first_time() > begin_);
  const bool apart = want_begin_ >= end_ || want_end_ <= begin_;
  if (other || gone || apart) begin_anew();
}

double Distribution::progress() const {
  if (complete()) return 1;
  const auto wanted = static_cast<double>(series_->count(want_begin_, want_end_));
  const auto both = static_cast<double>(series_->count(std::max(begin_, want_begin_), std::min(end_, want_end_)));
  return wanted == 0 ? 1 : both / wanted;
}

void Distribution::take(Nanoseconds begin, Nanoseconds end, bool add) {
  const auto one = add ? std::uint64_t{1} : ~std::uint64_t{0};
  const auto fine_one = static_cast<std::uint32_t>(one);
  const auto bins = static_cast<std::ptrdiff_t>(bins_.size());
  const double per_unit = 1 / grid_.width();
  series_->for_each(begin, end, [&](Nanoseconds, float sample) {
    if (std::isnan(sample)) return;
    const auto value = static_cast<double>(sample);
    count_ += one;
    fine_[ordered(sample) >> kDropped] += fine_one;
    if (value < grid_.low) {
      below_ += one;
    } else if (value >= grid_.high) {
      above_ += one;
    } else {
      const auto bin = static_cast<std::ptrdiff_t>((value - grid_.low) * per_unit);
      bins_[static_cast<std::size_t>(std::min(bin, bins - 1))] += one;
    }
  });
}

bool Distribution::work(std::size_t samples) {
  // Portions by time: as long as this many samples take on the average of what is kept.
  const auto portion = [&](Nanoseconds from, Nanoseconds to) {
    const auto there = series_->count(from, to);
    const double part = there <= samples ? 1 : static_cast<double>(samples) / static_cast<double>(there);
    samples -= std::min(samples, there);
    return part == 1 ? to - from
                     : std::max<Nanoseconds>(static_cast<Nanoseconds>(part * static_cast<double>(to - from)), 1);
  };
  if (series_ == nullptr) return true;
  if (end_ < want_end_ && samples > 0) {
    const auto until = end_ + portion(end_, want_end_);
    take(end_, until, true);
    end_ = until;
  }
  if (begin_ > want_begin_ && samples > 0) {
    const auto from = begin_ - portion(want_begin_, begin_);
    take(from, begin_, true);
    begin_ = from;
  }
  if (begin_ < want_begin_ && samples > 0) {
    const auto until = begin_ + portion(begin_, want_begin_);
    take(begin_, until, false);
    begin_ = until;
  }
  if (end_ > want_end_ && samples > 0) {
    const auto from = end_ - portion(want_end_, end_);
    take(from, end_, false);
    end_ = from;
  }
  return complete();
}

std::optional<double> Distribution::quantile(double fraction) const {
  const auto found = extent();
  if (count_ == 0 || !found) return std::nullopt;
  const auto wanted =
      std::max<std::uint64_t>(static_cast<std::uint64_t>(std::ceil(fraction * static_cast<double>(count_))), 1);
  std::uint64_t seen = 0;
  for (std::size_t bin = ordered(found->min) >> kDropped; bin < fine_.size(); ++bin) {
    seen += fine_[bin];
    if (seen < wanted) continue;
    const auto lower = from_ordered(static_cast<std::uint32_t>(bin) << kDropped);
    const auto upper = from_ordered(((static_cast<std::uint32_t>(bin) + 1) << kDropped) - 1);
    // Whole numbers stand alone in their bins up to 1024: as such they are told.
    const bool alone = std::floor(lower) == lower && upper - lower < 1 && std::floor(upper) == lower;
    const auto edge = static_cast<double>(alone ? lower : upper);
    return std::clamp(edge, static_cast<double>(found->min), static_cast<double>(found->max));
  }
  return static_cast<double>(found->max);
}

std::optional<MinMaxSeries::Extent> Distribution::extent() const {
  return series_ == nullptr ? std::nullopt : series_->extent(begin_, end_);
}

std::vector<Distribution::Hit> Distribution::hits(std::ptrdiff_t bin, std::size_t most) const {
  std::vector<Hit> ring;
  std::size_t next = 0;
  if (series_ == nullptr || most == 0) return ring;
  const auto bins = static_cast<std::ptrdiff_t>(bins_.size());
  const double per_unit = 1 / grid_.width();
  series_->for_each(begin_, end_, [&](Nanoseconds time, float sample) {
    if (std::isnan(sample)) return;
    const auto value = static_cast<double>(sample);
    std::ptrdiff_t place = -1;
    if (value >= grid_.high) {
      place = bins;
    } else if (value >= grid_.low) {
      place = std::min(static_cast<std::ptrdiff_t>((value - grid_.low) * per_unit), bins - 1);
    }
    if (place != bin) return;
    if (ring.size() < most) {
      ring.push_back({time, sample});
    } else {
      ring[next] = {time, sample};
      next = (next + 1) % most;
    }
  });
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(next), ring.end());
  return ring;
}

}  // namespace syncline
