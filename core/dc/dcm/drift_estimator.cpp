// SPDX-License-Identifier: Apache-2.0
#include "dc/dcm/drift_estimator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "support/confidence.h"

namespace syncline::dc {
namespace {

/// A slope so far from the median, in mean absolute deviations and at least in ppm, is a step and no rate.
constexpr double kDeviations = 8;
constexpr double kLeastGatePpm = 2;
/// So many slopes in a row that agree with each other and not with the median: the rate is another one.
constexpr std::size_t kRateIsNew = 3;
/// Of a block, to be seen in its two halves of at least so many samples.
constexpr double kOtherTrendPpm = 5;
constexpr std::ptrdiff_t kLeastHalf = 4;
/// A median of fewer says little: with long cycles a block is longer.
constexpr std::size_t kLeastSamples = 20;
constexpr double kResolution = 1;  // ns

double median_of(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool DriftEstimator::observe(Nanoseconds host_time, Nanoseconds reference_time) {
  if (sample_count_ == 0) block_begin_ = host_time;
  const bool full = host_time - block_begin_ >= block_ && sample_count_ >= kLeastSamples;
  if (full) {
    close_block();
    block_begin_ = host_time;
  }
  const auto spacing = block_ / static_cast<Nanoseconds>(kSamples);
  const bool wanted = sample_count_ == 0 || host_time - samples_[sample_count_ - 1].host >= spacing;
  if (wanted && sample_count_ < kSamples) samples_[sample_count_++] = {host_time, reference_time - host_time};
  return full && slope_count_ > 0;
}

void DriftEstimator::close_block() {
  const auto point = median_sample();
  sample_count_ = 0;
  if (has_point_ && point.host > last_point_.host) {
    const auto span = static_cast<double>(point.host - last_point_.host);
    last_ppm_ = static_cast<double>(point.offset - last_point_.offset) / span * 1e6;
    add_slope({last_ppm_, span});
  }
  last_point_ = point;
  has_point_ = true;
}

/// At the middle one of the sampling times, so that points are a block apart however the noise fell: two that are close
/// to each other would say nothing of the rate, and look like a step.
DriftEstimator::Point DriftEstimator::median_sample() {
  const auto begin = samples_.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(sample_count_);
  const auto first = samples_.front();
  double trend = ppm_;
  // Without the drift that is known: else the middle of the block would be called its median.
  const auto level = [&](const Point& p) {
    return static_cast<double>(p.offset - first.offset) - trend * 1e-6 * static_cast<double>(p.host - first.host);
  };
  // A rate that is quite another one shows within the block.
  const auto half = static_cast<std::ptrdiff_t>(sample_count_ / 2);
  if (half >= kLeastHalf) {
    std::array<double, kSamples> levels{};
    std::transform(begin, end, levels.begin(), level);
    const double rise =
        median_of(std::span(levels).subspan(static_cast<std::size_t>(half), static_cast<std::size_t>(half))) -
        median_of(std::span(levels).first(static_cast<std::size_t>(half)));
    const double more = rise / static_cast<double>(begin[half].host - first.host) * 1e6;
    if (std::abs(more) > kOtherTrendPpm) trend += more;
  }
  // Where the trend is still wrong the middle level is that of the middle time, also where the block has holes.
  const auto host = begin[half].host;
  const auto middle = begin + half;
  std::nth_element(begin, middle, end, [&](const Point& a, const Point& b) { return level(a) < level(b); });
  const double offset = level(*middle) + trend * 1e-6 * static_cast<double>(host - first.host);
  return {host, first.offset + static_cast<Nanoseconds>(std::llround(offset))};
}

void DriftEstimator::add_slope(const Slope& slope) {
  if (slope_count_ == kWindow) {
    std::shift_left(slopes_.begin(), slopes_.end(), 1);
    --slope_count_;
  }
  slopes_[slope_count_++] = slope;
  std::array<double, kWindow> values{};
  const auto used = std::span(values).first(slope_count_);
  std::transform(slopes_.begin(), slopes_.begin() + static_cast<std::ptrdiff_t>(slope_count_), used.begin(),
                 [](const Slope& s) { return s.ppm; });
  const double median = median_of(used);
  for (auto& value : used) value = std::abs(value - median);
  const double gate = std::max(kDeviations * median_of(used), kLeastGatePpm);
  if (rate_has_changed(median, gate)) {
    std::shift_left(slopes_.begin(), slopes_.begin() + static_cast<std::ptrdiff_t>(slope_count_),
                    static_cast<std::ptrdiff_t>(slope_count_ - kRateIsNew));
    slope_count_ = kRateIsNew;
    ppm_ = slopes_[kRateIsNew - 1].ppm;
    half_width_ppm_.reset();
    return;
  }
  draw_line(median, gate);
}

bool DriftEstimator::rate_has_changed(double median, double gate) const {
  if (slope_count_ <= kRateIsNew) return false;
  double low = slopes_[slope_count_ - 1].ppm, high = low;
  for (std::size_t i = slope_count_ - kRateIsNew; i < slope_count_; ++i) {
    if (std::abs(slopes_[i].ppm - median) <= gate) return false;
    low = std::min(low, slopes_[i].ppm);
    high = std::max(high, slopes_[i].ppm);
  }
  return high - low < gate && (low > median) == (high > median);
}

/// Least squares through the points that the slopes connect. A step in one of them is taken for the median rate.
void DriftEstimator::draw_line(double median, double gate) {
  std::array<double, kWindow + 1> times{}, levels{};
  const auto points = slope_count_ + 1;
  double sum_t = 0, sum_l = 0, sum_tt = 0, sum_tl = 0;
  for (std::size_t i = 0; i < slope_count_; ++i) {
    const auto& slope = slopes_[i];
    const double rest = std::abs(slope.ppm - median) <= gate ? slope.ppm - median : 0;
    times[i + 1] = times[i] + slope.span;
    levels[i + 1] = levels[i] + rest * slope.span;
    sum_t += times[i + 1];
    sum_l += levels[i + 1];
    sum_tt += times[i + 1] * times[i + 1];
    sum_tl += times[i + 1] * levels[i + 1];
  }
  const auto n = static_cast<double>(points);
  const double spread = sum_tt - sum_t * sum_t / n;
  ppm_ = spread > 0 ? median + (sum_tl - sum_t * sum_l / n) / spread : median;
  half_width_ppm_ = slope_half_width(std::span(times).first(points), std::span(levels).first(points));
  // Times are whole nanoseconds, as wrong at both ends of the line as that.
  if (half_width_ppm_) *half_width_ppm_ += kResolution / times[slope_count_] * 1e6;
}

}  // namespace syncline::dc
