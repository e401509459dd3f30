// SPDX-License-Identifier: Apache-2.0
#include "trace/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "trace/mtie.h"

namespace syncline {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLanes = 4;
constexpr std::size_t kFewestTerms = 32;
constexpr double kSteady = 0.95;  // slope of what moves away at a rate that stays

bool is_set(const std::atomic<bool>* stop) { return stop != nullptr && stop->load(std::memory_order_relaxed); }

/// Sums of one observation time over all stretches.
struct StabilitySums {
  double second = 0;  // squares of second differences
  std::size_t second_terms = 0;
  double plain = 0;
  std::size_t plain_terms = 0;
  double averaged = 0;  // squares of second differences of averages over m
  std::size_t averaged_terms = 0;
  double first = 0;  // squares of first differences
  std::size_t first_terms = 0;
  std::size_t windows = 0;
};

/// Independent partial sums: the processor need not wait for one addition before the next.
class LaneSum {
 public:
  void add(std::size_t lane, double value) { lanes_[lane] += value; }
  [[nodiscard]] double total() const { return (lanes_[0] + lanes_[1]) + (lanes_[2] + lanes_[3]); }

 private:
  double lanes_[kLanes] = {};
};

/// Sums of one observation time of m intervals over a stretch, in one pass: memory is what a long one costs.
///
/// First differences are x(i+m) - x(i), second ones those of these; an average over m has the sum over a window of m
/// second differences, which is moved on by one sample each time.
template <class Value>
void add_differences(std::span<const Value> x, std::size_t m, StabilitySums& sums) {
  const auto n = x.size();
  if (n <= m) return;
  const auto* a = x.data();
  const auto at = [a](std::size_t i) { return static_cast<double>(a[i]); };
  const std::size_t seconds = n > 2 * m ? n - 2 * m : 0;
  const std::size_t moves = n > 3 * m ? n - 3 * m : 0;
  LaneSum first, second, averaged;
  double window = 0;
  if (n >= 3 * m) {
    for (std::size_t i = 0; i < m; ++i) window += (at(i + 2 * m) - at(i + m)) - (at(i + m) - at(i));
    averaged.add(0, window * window);
    sums.averaged_terms += moves + 1;
  }
  std::size_t i = 0;
  for (; i + kLanes <= moves; i += kLanes) {
    double step[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const double begin = at(i + lane), one_later = at(i + lane + m), two_later = at(i + lane + 2 * m);
      const double one = one_later - begin, next = two_later - one_later, two = next - one;
      first.add(lane, one * one);
      second.add(lane, two * two);
      step[lane] = ((at(i + lane + 3 * m) - two_later) - next) - two;
    }
    // The window need not wait for four additions in a row.
    const double pair = step[0] + step[1];
    const double places[kLanes] = {window + step[0], window + pair, window + (pair + step[2]),
                                   window + (pair + (step[2] + step[3]))};
    for (std::size_t lane = 0; lane < kLanes; ++lane) averaged.add(lane, places[lane] * places[lane]);
    window = places[kLanes - 1];
  }
  for (; i < n - m; ++i) {
    const double one = at(i + m) - at(i);
    first.add(i % kLanes, one * one);
    if (i >= seconds) continue;
    const double next = at(i + 2 * m) - at(i + m);
    const double two = next - one;
    second.add(i % kLanes, two * two);
    if (i >= moves) continue;
    window += ((at(i + 3 * m) - at(i + 2 * m)) - next) - two;
    averaged.add(i % kLanes, window * window);
  }
  sums.first += first.total();
  sums.first_terms += n - m;
  sums.windows += (n - 1) / m;
  sums.second += second.total();
  sums.second_terms += seconds;
  sums.averaged += averaged.total();
  for (i = 0; i + 2 * m < n; i += m) {
    const double two = at(i + 2 * m) - 2 * at(i + m) + at(i);
    sums.plain += two * two;
    ++sums.plain_terms;
  }
}

StabilityPoint point_of(const StabilitySums& sums, std::size_t m, double interval, double unit, double mtie) {
  StabilityPoint point;
  point.tau = static_cast<double>(m) * interval;
  const auto mean = [](double sum, std::size_t terms) {
    return terms == 0 ? kNothing : sum / static_cast<double>(terms);
  };
  const double rate = unit / (point.tau * std::numbers::sqrt2);
  point.adev = rate * std::sqrt(mean(sums.second, sums.second_terms));
  point.plain_adev = rate * std::sqrt(mean(sums.plain, sums.plain_terms));
  point.mdev = rate / static_cast<double>(m) * std::sqrt(mean(sums.averaged, sums.averaged_terms));
  point.tdev = point.mdev * point.tau / std::numbers::sqrt3 / unit;
  point.tie_rms = std::sqrt(mean(sums.first, sums.first_terms));
  point.mtie = mtie;
  point.terms = sums.second_terms;
  point.windows = sums.windows;
  return point;
}

template <class Value>
std::vector<StabilityPoint> octaves_of(Stretches<Value> stretches, double interval, double unit,
                                       const std::atomic<bool>* stop) {
  std::size_t longest = 0;
  for (const auto& stretch : stretches) longest = std::max(longest, stretch.size());
  std::size_t octaves = 0;
  while ((std::size_t{2} << octaves) < longest) ++octaves;  // at least one second difference
  const auto mtie = mtie_octaves(stretches, octaves, stop);
  std::vector<StabilityPoint> points;
  for (std::size_t octave = 0; octave < octaves && !is_set(stop); ++octave) {
    const auto m = std::size_t{1} << octave;
    StabilitySums sums;
    for (const auto& stretch : stretches) {
      add_differences(stretch, m, sums);
    }
    points.push_back(point_of(sums, m, interval, unit, mtie[octave]));
  }
  return points;
}

/// Any window: the smallest and largest of the samples in it stand in front of two queues that only fall and only rise.
double mtie_of(std::span<const double> x, std::size_t m) {
  std::vector<std::size_t> high(x.size()), low(x.size());
  std::size_t high_first = 0, high_end = 0, low_first = 0, low_end = 0;
  double result = kNothing;
  for (std::size_t i = 0; i < x.size(); ++i) {
    while (high_end > high_first && x[high[high_end - 1]] <= x[i]) --high_end;
    while (low_end > low_first && x[low[low_end - 1]] >= x[i]) --low_end;
    high[high_end++] = i;
    low[low_end++] = i;
    if (i < m) continue;
    if (high[high_first] + m < i) ++high_first;
    if (low[low_first] + m < i) ++low_first;
    const double span = x[high[high_first]] - x[low[low_first]];
    if (!(result >= span)) result = span;
  }
  return result;
}

}  // namespace

std::vector<StabilityPoint> stability_octaves(Stretches<float> stretches, double interval, double unit,
                                              const std::atomic<bool>* stop) {
  return octaves_of(stretches, interval, unit, stop);
}
std::vector<StabilityPoint> stability_octaves(Stretches<double> stretches, double interval, double unit,
                                              const std::atomic<bool>* stop) {
  return octaves_of(stretches, interval, unit, stop);
}

StabilityPoint stability_at(Stretches<double> stretches, std::size_t m, double interval, double unit) {
  StabilitySums sums;
  double mtie = kNothing;
  m = std::max<std::size_t>(m, 1);
  for (const auto& stretch : stretches) {
    add_differences(stretch, m, sums);
    const double span = mtie_of(stretch, m);
    if (!(mtie >= span) && !std::isnan(span)) mtie = span;
  }
  return point_of(sums, m, interval, unit, mtie);
}

StabilityPoint stability_bound(double limit, double tau, double unit) {
  // A second difference of values within the limit is four times it at most, a first one twice.
  StabilityPoint point;
  point.tau = tau;
  point.adev = point.plain_adev = point.mdev = 4 * limit * unit / (tau * std::numbers::sqrt2);
  point.tdev = point.mdev * tau / std::numbers::sqrt3 / unit;
  point.tie_rms = point.mtie = 2 * limit;
  return point;
}

namespace {

/// The last octaves rest on a handful of terms and windows: they decide nothing.
std::vector<StabilityPoint> sure_points(const std::vector<StabilityPoint>& points) {
  std::vector<StabilityPoint> sure;
  for (const auto& point : points) {
    if (point.terms >= kFewestTerms && point.windows >= kFewestWindows) sure.push_back(point);
  }
  return sure;
}

double steady_rate(const std::vector<StabilityPoint>& sure) {
  if (sure.size() < 4) return 0;
  const auto& from = sure[sure.size() - 3];
  const auto& to = sure.back();
  if (!(from.tie_rms > 0) || std::log(to.tie_rms / from.tie_rms) < kSteady * std::log(to.tau / from.tau)) return 0;
  return to.tie_rms / to.tau;
}

}  // namespace

StabilityReading read_stability(const std::vector<StabilityPoint>& points) {
  StabilityReading reading;
  auto sure = sure_points(points);
  reading.runs_away = steady_rate(sure);
  std::erase_if(sure, [](const StabilityPoint& point) { return !(point.adev > 0) || !(point.tdev > 0); });
  if (sure.size() < 4) return reading;
  const auto slope = [&](std::size_t from, std::size_t to) {
    return std::log(sure[to].adev / sure[from].adev) / std::log(sure[to].tau / sure[from].tau);
  };
  const auto last = sure.size() - 1;
  reading.short_slope = slope(0, 2);
  reading.long_slope = slope(last - 2, last);
  reading.jitter = *reading.short_slope < -0.4;
  reading.drift = *reading.long_slope > 0.4;
  double highest = 0;
  // Of a sine the time deviation has its hump at 0.4 of the period and falls on both sides of it.
  for (std::size_t i = 1; i < last; ++i) {
    if (sure[i].tdev < sure[i - 1].tdev || sure[i].tdev <= sure[i + 1].tdev) continue;
    double before = sure[i].tdev;
    double behind = sure[i].tdev;
    for (std::size_t k = 0; k < i; ++k) before = std::min(before, sure[k].tdev);
    for (std::size_t k = i + 1; k <= last; ++k) behind = std::min(behind, sure[k].tdev);
    if (sure[i].tdev < 1.4 * std::max(before, behind) || sure[i].tdev <= highest) continue;
    highest = sure[i].tdev;
    reading.hunting_period = sure[i].tau / 0.4;
  }
  return reading;
}

}  // namespace syncline
