// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>

#include "support/types.h"

namespace syncline {

struct CycleSample;

/// The system time of the reference clock at moments of the host's clock, as frames have read it. Kept are readings
/// that lie apart: what is between two of them is interpolated, which is off by no more than the host's jitter.
class ReferenceTimes {
 public:
  static constexpr Nanoseconds kApart = 100 * kMillisecond;
  /// Two readings whose difference to the host's clock differs by more are on both sides of a step.
  static constexpr Nanoseconds kStep = kMillisecond;
  /// Nothing is told further than this from a reading.
  static constexpr Nanoseconds kReach = 10 * kSecond;
  static constexpr std::size_t kMost = 1U << 18;  // seven hours, 6 MiB

  /// In the order of their times.
  void add(std::span<const CycleSample> samples);
  /// ns since 2000-01-01; nothing where it is not known.
  [[nodiscard]] std::optional<Nanoseconds> at(Nanoseconds host) const;

 private:
  struct Reading {
    Nanoseconds host = 0, reference = 0;
    bool steps = false;  // nothing leads to it from the one before
  };
  std::deque<Reading> readings_;
  std::optional<Reading> newest_;
};

}  // namespace syncline
