// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "trace/histogram.h"
#include "trace/lasting_magnitude.h"
#include "trace/signals.h"
#include "trace/statistics.h"
#include "trace/untold.h"

/// A stretch of a run as numbers, of samples alone: counted as the overview counts what came since it was armed.
namespace syncline {

/// One signal over the stretch, in its unit.
struct RangeFigure {
  struct Reading {
    Nanoseconds time = 0;  // host clock
    double value = 0;
  };
  std::optional<Reading> newest;   // the latest of the stretch
  std::optional<Reading> largest;  // magnitude
  Statistics statistics;           // signed where the signal is
  Histogram magnitudes;            // of whole numbers; empty: they are none

  void add(Nanoseconds time, const SignalNumber& number);
  /// Magnitude that `fraction` (0..1] of the values do not exceed; nothing without values, or where they are not whole.
  [[nodiscard]] std::optional<std::int64_t> quantile(double fraction) const;
  /// Part of the limit that the largest magnitude leaves, negative when it was exceeded; nothing without both.
  [[nodiscard]] std::optional<double> margin(double limit) const;
};

class RangeFigures {
 public:
  struct OfSignal {
    Signal signal{};
    RangeFigure figure{};
    /// Of the filtered DCM error alone: what its limit is for.
    LastingMagnitude lasting{};
  };
  struct OfSlave {
    RangeFigure deviation;  // of the readings as a follower of the reference clock, ns
    /// SM2 events in the stretch; nothing: it has no such counter, or it was read less than twice.
    std::optional<std::uint64_t> missed;
  };

  /// [begin, end), host clock. `armed`: only the cycles that the overview of an armed run counts.
  RangeFigures(std::size_t slaves, Nanoseconds begin, Nanoseconds end, bool armed);
  /// All samples of the run, in their order.
  void add(std::span<const CycleSample> samples);

  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }
  /// Nothing where an imported run does not tell.
  [[nodiscard]] std::optional<std::uint64_t> lost_frames() const { return told(kFramesUntold, lost_frames_); }
  [[nodiscard]] std::optional<std::uint64_t> wkc_errors() const { return told(kExpectedUntold, wkc_errors_); }
  [[nodiscard]] std::optional<std::uint64_t> skipped_cycles() const { return told(kLatenessUntold, skipped_cycles_); }
  /// Of the bus, those that have a value of their own in every cycle or reading, in the order of their table.
  [[nodiscard]] const std::vector<OfSignal>& signals() const { return signals_; }
  [[nodiscard]] const std::vector<OfSlave>& slaves() const { return slaves_; }

 private:
  void add(const CycleSample& sample);
  void add_missed(const CycleSample& sample);
  [[nodiscard]] std::optional<std::uint64_t> told(UntoldFlag what, std::uint64_t count) const {
    return (untold_ & what) != 0 ? std::nullopt : std::optional(count);
  }

  Nanoseconds begin_, end_;
  bool armed_;
  std::uint16_t untold_ = 0;  // by some cycle
  std::uint64_t cycles_ = 0, lost_frames_ = 0, wkc_errors_ = 0, skipped_cycles_ = 0;
  std::vector<OfSignal> signals_;
  std::vector<OfSlave> slaves_;
  std::vector<std::optional<std::uint32_t>> counters_;  // of missed SM2 events, as read last
};

}  // namespace syncline
