// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "support/types.h"
#include "trace/even_samples.h"
#include "trace/spectrum.h"
#include "trace/stability.h"

namespace syncline {

class MinMaxSeries;

/// What a stretch of a signal says of its stability, and on how much that rests.
struct SignalStudy {
  double interval = 0;                 // s between two samples; 0: there are none
  std::size_t given = 0, used = 0;     // samples without the gaps, and those in even stretches
  std::size_t gaps = 0, uneven = 0;    // see EvenSamples
  std::vector<StabilityPoint> points;  // of the observation times with kFewestWindows at least
  StabilityReading reading;            // of these
  Spectrum spectrum;
};
/// `unit` of the samples in s. For a thread of its own: two seconds for 10 million samples. Once `stop` is true it
/// ends, and what it gives then is no study.
[[nodiscard]] SignalStudy study_of(const EvenSamples& samples, double unit, const std::atomic<bool>* stop = nullptr);

/// Copies [begin, end) of a series in portions, so that whoever lives in its thread never waits. Samples that leave the
/// series before they were copied are a gap.
class SampleGathering {
 public:
  /// Begins anew; `longest` as in EvenSamples. The series must stay until the end or drop().
  void aim(const MinMaxSeries& series, Nanoseconds begin, Nanoseconds end, Nanoseconds longest);
  void drop();
  /// Copies about `samples` more; true when all are there.
  bool work(std::size_t samples);
  [[nodiscard]] bool complete() const { return series_ == nullptr || next_ >= end_; }
  /// 0..1.
  [[nodiscard]] double progress() const;
  /// What was copied, which is not here any more; the stretches are found by EvenSamples::finish().
  [[nodiscard]] EvenSamples take();
  [[nodiscard]] Nanoseconds longest() const { return longest_; }

 private:
  const MinMaxSeries* series_ = nullptr;
  Nanoseconds begin_ = 0, next_ = 0, end_ = 0, longest_ = 0;
  EvenSamples samples_;
};

}  // namespace syncline
