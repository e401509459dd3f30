// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "support/types.h"
#include "trace/histogram.h"
#include "trace/statistics.h"

namespace syncline {

class MinMaxSeries;

/// Mean, root mean square, quantiles and the largest of a series over a stretch: every sample of it counts, whole
/// numbers exactly. Made some samples at a time. Lives in the thread of the series.
class StretchFigures {
 public:
  /// Of [begin, end); begins anew where that is another stretch or series. Null: of nothing. The series must stay.
  void aim(const MinMaxSeries* series, Nanoseconds begin, Nanoseconds end);
  /// About so many samples more; true: all are in.
  bool work(std::size_t samples);
  [[nodiscard]] bool complete() const { return series_ == nullptr || done_ >= end_; }

  /// Of what is in, signed where the series is.
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }
  [[nodiscard]] const Histogram& magnitudes() const { return magnitudes_; }

 private:
  const MinMaxSeries* series_ = nullptr;
  Nanoseconds begin_ = 0, end_ = 0, done_ = 0;  // before done_ all are in
  std::size_t samples_ = 0;                     // that the stretch had
  Statistics statistics_;
  Histogram magnitudes_;
};

}  // namespace syncline
