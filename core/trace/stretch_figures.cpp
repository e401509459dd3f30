// SPDX-License-Identifier: Apache-2.0
#include "trace/stretch_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "trace/min_max_series.h"

namespace syncline {

void StretchFigures::aim(const MinMaxSeries* series, Nanoseconds begin, Nanoseconds end) {
  end = std::max(begin, end);
  // Samples that come in or go out behind what was counted are told by their number.
  const auto samples = series == nullptr ? 0 : series->count(begin, end);
  if (series == series_ && begin == begin_ && end == end_ && samples == samples_) return;
  series_ = series;
  begin_ = done_ = begin;
  end_ = end;
  samples_ = samples;
  statistics_.clear();
  magnitudes_.clear();
}

bool StretchFigures::work(std::size_t samples) {
  if (complete()) return true;
  const auto there = series_->count(done_, end_);
  auto until = end_;
  if (there > samples) {
    const double part = static_cast<double>(samples) / static_cast<double>(there);
    until = done_ + std::max<Nanoseconds>(static_cast<Nanoseconds>(part * static_cast<double>(end_ - done_)), 1);
  }
  series_->for_each(done_, until, [this](Nanoseconds, float value) {
    if (std::isnan(value)) return;
    statistics_.add(static_cast<double>(value));
    magnitudes_.add(std::llabs(std::llround(static_cast<double>(value))));
  });
  done_ = until;
  return complete();
}

}  // namespace syncline
