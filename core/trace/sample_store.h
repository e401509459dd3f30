// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "channels/cycle_sample.h"
#include "trace/min_max_series.h"

namespace syncline {

/// The samples of a run, as series that plots and reports read. Time is the host clock's send time.
/// Lost frames and values that were not valid are gaps; cycles that are missing in the stream (ring
/// overruns) leave a gap too. Not thread-safe: lives where the samples are drained.
class SampleStore {
 public:
  enum class Series : std::uint8_t {
    kDeviation,  // ns, of the slaves that follow the reference clock: CycleSample::deviation_ns
    kDcmError,   // ns, raw
    kDcmErrorFiltered,
    kDrift,      // ppm
    kLateness,   // ns
    kRoundTrip,  // ns
  };
  static constexpr std::size_t kSeriesCount = 6;

  /// `cycle_capacity`: cycles that are kept; per-slave series keep as many readings divided by the
  /// number of slaves (at least 8192 each).
  explicit SampleStore(std::size_t slaves = 0, std::size_t cycle_capacity = 1U << 20);

  void append(std::span<const CycleSample> samples);
  void clear();

  [[nodiscard]] const MinMaxSeries& series(Series which) const { return series_[static_cast<std::size_t>(which)]; }
  /// Signed 0x092C readings of one slave, ns.
  [[nodiscard]] const MinMaxSeries& slave_deviation(std::size_t position) const { return deviation_.at(position); }
  /// Missed SM2 events of one slave: the counter's readings, a step series. Readings that repeat the
  /// last value are kept at most every 100 ms, so that hours fit.
  [[nodiscard]] const MinMaxSeries& slave_sm2_missed(std::size_t position) const { return sm2_missed_.at(position); }
  [[nodiscard]] std::size_t slave_count() const { return deviation_.size(); }
  [[nodiscard]] bool empty() const { return series_.front().empty(); }
  [[nodiscard]] Nanoseconds first_time() const { return series_.front().first_time(); }
  [[nodiscard]] Nanoseconds last_time() const { return series_.front().last_time(); }
  /// Cycles that the stream skipped.
  [[nodiscard]] std::uint64_t missing_cycles() const { return missing_cycles_; }

 private:
  void append(const CycleSample& sample);
  MinMaxSeries& at(Series which) { return series_[static_cast<std::size_t>(which)]; }

  std::vector<MinMaxSeries> series_;
  std::vector<MinMaxSeries> deviation_, sm2_missed_;
  std::uint64_t next_cycle_ = 0;
  bool any_ = false;
  std::uint64_t missing_cycles_ = 0;
};

}  // namespace syncline
