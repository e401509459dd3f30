// SPDX-License-Identifier: Apache-2.0
#include "trace/even_samples.h"

#include <algorithm>
#include <cmath>

#include "support/large_pages.h"
#include "trace/min_max_series.h"

namespace syncline {
namespace {

constexpr std::size_t kLooked = 20'001;  // distances that are enough for the usual one

/// The usual distance of two samples: the median of some of them, which a few gaps do not move.
double usual_distance(const std::vector<Nanoseconds>& times) {
  if (times.size() < 2) return 0;
  const auto step = std::max<std::size_t>((times.size() - 1) / kLooked, 1);
  std::vector<Nanoseconds> distances;
  for (std::size_t i = 1; i < times.size(); i += step) distances.push_back(times[i] - times[i - 1]);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::ranges::nth_element(distances, middle);
  return static_cast<double>(*middle);
}

}  // namespace

EvenSamples::EvenSamples(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end, Nanoseconds longest) {
  reserve(series.count(begin, end));
  series.for_each(begin, end, [this](Nanoseconds time, float value) { add(time, value); });
  finish(longest);
}

void EvenSamples::reserve(std::size_t count) {
  reserve_in_large_pages(times_, count);
  reserve_in_large_pages(values_, count);
}

void EvenSamples::add(Nanoseconds time, float value) {
  times_.push_back(time);
  values_.push_back(value);
}

void EvenSamples::finish(Nanoseconds longest) {
  const double usual = usual_distance(times_);
  const double late = longest > 0 ? std::min(kLate * usual, static_cast<double>(longest)) : kLate * usual;
  double lengths = 0;
  std::size_t distances = 0;
  std::size_t first = 0;
  const auto close = [&](std::size_t end) {
    if (end - first >= kShortest) {
      stretches_.emplace_back(std::span(values_).subspan(first, end - first));
      used_ += end - first;
      lengths += static_cast<double>(times_[end - 1] - times_[first]);
      distances += end - 1 - first;
      for (auto i = first + 1; i < end; ++i) {
        const auto distance = static_cast<double>(times_[i] - times_[i - 1]);
        if (std::abs(distance - usual) > kUneven * usual) ++uneven_;
      }
    }
  };
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const bool gap = std::isnan(values_[i]);
    if (!gap) ++given_;
    if (gap || (i > first && static_cast<double>(times_[i] - times_[i - 1]) > late)) {
      close(i);
      first = gap ? i + 1 : i;
    }
  }
  if (first < values_.size()) close(values_.size());
  // A late sample and the early one behind it are one interval each on the average.
  interval_ = distances == 0 ? usual : lengths / static_cast<double>(distances);
  times_ = {};
}

}  // namespace syncline
