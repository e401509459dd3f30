// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "support/types.h"
#include "trace/histogram.h"

namespace syncline {

struct CycleSample;
struct JitterProfile;

/// Learns from the cycles with process data (SAFEOP, OP) what their host does to times; feed every sample that is
/// drained.
class HostRecorder {
 public:
  explicit HostRecorder(Nanoseconds cycle_time) : cycle_time_(cycle_time) {}
  void add(std::span<const CycleSample> samples);

  /// From so many on a profile says something: the latest of a thousand is in it.
  static constexpr std::uint64_t kLeastCycles = 1'000;
  /// Those with process data.
  [[nodiscard]] std::uint64_t cycles() const { return wake_up_.count(); }
  /// Where the reference clock's time came with the frames, the stamp error is how much later than its neighbours a
  /// frame passed that clock; without, how much longer than the shortest its way out and back took, which takes the
  /// receiving side's errors for those of sending. Empty before the first cycle.
  [[nodiscard]] JitterProfile profile() const;

 private:
  /// Readings on each side of one; the median of them all is what this one should have been, also while a clock drifts.
  static constexpr std::size_t kNeighbours = 16;
  void add_reading(Nanoseconds reference_less_send);

  Nanoseconds cycle_time_;
  Histogram wake_up_, round_trip_, stalls_;
  std::vector<Nanoseconds> readings_;       // the latest 2 * kNeighbours + 1
  std::vector<std::int32_t> stamp_errors_;  // about their own median, both signs
  Nanoseconds first_ = 0, last_ = 0;        // send times; 0: none
};

}  // namespace syncline
