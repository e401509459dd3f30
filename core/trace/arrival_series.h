// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "trace/min_max_series.h"
#include "trace/sync0_slaves.h"

namespace syncline {

struct CycleSample;

/// When the frame of each cycle passed the reference clock, in the SYNC grid and for the whole bus once; where that
/// lies in the SYNC0 period of a slave is made of it when somebody looks. Whole nanoseconds up to a cycle of 16 ms,
/// beyond that to 2^-24 of the cycle. Not thread-safe.
class ArrivalSeries {
 public:
  /// Series of so many slaves are kept that were made; the one that was asked for least recently goes.
  static constexpr std::size_t kMostKept = 16;

  /// `axis`: series with a value in every cycle, whose times are kept there. `grid`: see sync_grid(); 0: not known.
  ArrivalSeries(const MinMaxSeries& axis, std::vector<Sync0Slave> slaves, Nanoseconds cycle_time, Nanoseconds grid);

  /// After the axis got the same times.
  void append(std::span<const CycleSample> samples, std::span<const Nanoseconds> times);
  void leave_gap(Nanoseconds time);
  /// See MinMaxSeries::show_until().
  void show_until(Nanoseconds time);

  /// Time since the SYNC0 that began the period into which the slave's outputs came, ns; empty where that is not known.
  /// `delays`: its propagation delay, held. Stays until kMostKept others were asked for.
  [[nodiscard]] const MinMaxSeries& phase(std::size_t slave, const MinMaxSeries& delays);
  /// What was made of delays that are others now.
  void forget_made() { made_.clear(); }
  [[nodiscard]] const std::vector<Sync0Slave>& slaves() const { return slaves_; }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct Made {
    MinMaxSeries series;
    Nanoseconds done = INT64_MIN;  // up to here
    std::uint64_t asked = 0;
  };
  Made& made_for(std::size_t slave);
  void extend(Made& made, const Sync0Slave& slave, const MinMaxSeries& delays);

  std::vector<Sync0Slave> slaves_;
  Nanoseconds cycle_time_;
  std::int64_t turns_;  // cycles of the grid
  std::size_t capacity_;
  /// In the grid: which of its cycles, and how far in it. A float holds either, but not both.
  std::vector<MinMaxSeries> turn_, in_cycle_;  // one each; none: there is nobody to draw
  std::map<std::size_t, Made> made_;
  std::uint64_t asked_ = 0;
  MinMaxSeries none_{1};
  std::vector<float> turns_room_, in_cycle_room_;
};

}  // namespace syncline
