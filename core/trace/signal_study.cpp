// SPDX-License-Identifier: Apache-2.0
#include "trace/signal_study.h"

#include <algorithm>
#include <utility>

#include "trace/min_max_series.h"

namespace syncline {
namespace {

/// Of all squares about the mean, the part in the fullest `window` of neighbouring samples.
double fullest(Stretches<float> stretches, std::size_t window) {
  double sum = 0, count = 0;
  for (const auto stretch : stretches) {
    for (const float value : stretch) sum += static_cast<double>(value);
    count += static_cast<double>(stretch.size());
  }
  const auto mean = count > 0 ? sum / count : 0;
  const auto square = [mean](float value) {
    const auto off = static_cast<double>(value) - mean;
    return off * off;
  };
  double all = 0, most = 0;
  for (const auto stretch : stretches) {
    double in_window = 0;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      in_window += square(stretch[i]);
      all += square(stretch[i]);
      if (i >= window) in_window -= square(stretch[i - window]);
      most = std::max(most, in_window);
    }
  }
  return all > 0 ? most / all : 0;
}

/// A single step makes the same hump as a swing; but what swings comes again, all over the range.
void tell_disturbance(StabilityReading& reading, const EvenSamples& samples, double interval) {
  constexpr double kPeriods = 3, kNearlyAll = 0.9, kShortPart = 0.25;
  if (reading.hunting_period <= 0) return;
  const auto window = static_cast<std::size_t>(kPeriods * reading.hunting_period / interval);
  if (static_cast<double>(window) > kShortPart * static_cast<double>(samples.used())) return;
  if (fullest(samples.stretches(), window) < kNearlyAll) return;
  reading.disturbed_for = kPeriods * reading.hunting_period;
  reading.hunting_period = 0;
}

}  // namespace

SignalStudy study_of(const EvenSamples& samples, double unit, const std::atomic<bool>* stop) {
  SignalStudy study;
  study.interval = samples.interval() / 1e9;
  study.given = samples.given();
  study.used = samples.used();
  study.gaps = samples.gaps();
  study.uneven = samples.uneven();
  if (samples.stretches().empty() || study.interval <= 0) return study;
  study.points = stability_octaves(samples.stretches(), study.interval, unit, stop);
  std::erase_if(study.points, [](const StabilityPoint& point) { return point.windows < kFewestWindows; });
  study.reading = read_stability(study.points);
  tell_disturbance(study.reading, samples, study.interval);
  study.spectrum = spectrum_of(samples.stretches(), study.interval, stop);
  return study;
}

void SampleGathering::aim(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end, Nanoseconds longest) {
  series_ = &series;
  samples_ = {};
  longest_ = longest;
  begin_ = series.empty() ? begin : std::max(begin, series.first_time());
  end_ = std::max(begin_, series.empty() ? begin : std::min(end, series.last_time() + 1));
  next_ = begin_;
  samples_.reserve(series.count(begin_, end_));
}

void SampleGathering::drop() {
  series_ = nullptr;
  samples_ = {};
}

bool SampleGathering::work(std::size_t samples) {
  if (complete()) return true;
  // By time, as long as this many samples take on the average of what is left.
  const auto left = series_->count(next_, end_);
  const double part = left <= samples ? 1 : static_cast<double>(samples) / static_cast<double>(left);
  const auto until =
      part == 1 ? end_
                : next_ + std::max<Nanoseconds>(static_cast<Nanoseconds>(part * static_cast<double>(end_ - next_)), 1);
  series_->for_each(next_, until, [this](Nanoseconds time, float value) { samples_.add(time, value); });
  next_ = until;
  return complete();
}

double SampleGathering::progress() const {
  return complete() || end_ <= begin_ ? 1 : static_cast<double>(next_ - begin_) / static_cast<double>(end_ - begin_);
}

EvenSamples SampleGathering::take() {
  series_ = nullptr;
  return std::exchange(samples_, {});
}

}  // namespace syncline
