// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "trace/min_max_series.h"

namespace syncline {

/// A value that holds from one reading to the next: a count or a state. Kept are its changes, so that hours cost
/// little; it is never said to hold longer than somebody has heard of it.
class HeldSeries {
 public:
  /// Before anything is known of how often it is read.
  static constexpr Nanoseconds kPatience = 5 * kSecond;

  explicit HeldSeries(std::size_t capacity) : series_(capacity) {}

  /// A reading; the same one again, or an older one, changes nothing.
  void hear(Nanoseconds time, float value);
  /// As many readings one by one; not-a-number: nothing is known from then on.
  void hear(std::span<const Nanoseconds> times, std::span<const float> values);
  /// A change whose moment is known by itself, also where readings that are later have come before it. False, and
  /// nothing is changed, where another change is later still.
  bool change(Nanoseconds time, float value);
  /// From `time` on nothing is known, until it is heard again. A time before the last reading means just behind it.
  void lose(Nanoseconds time);
  /// Lost where the last reading is old for how often it was read lately: four times the longest interval, at least
  /// kPatience. What is read more seldom than that is known to be from its third reading on: two intervals that both
  /// were too long count, the shorter one; a single one is a pause.
  void expire(Nanoseconds now);
  void clear();
  /// What came so far were changes, not readings: how often it is read is not known by them.
  void forget_interval() { interval_ = 0; }
  /// See MinMaxSeries::show_until().
  void show_until(Nanoseconds time);

  /// Step series; after a gap (NaN) nothing holds.
  [[nodiscard]] const MinMaxSeries& series() const { return series_; }
  /// Until here its last value holds.
  [[nodiscard]] Nanoseconds heard() const;
  [[nodiscard]] bool is_known() const { return known_; }
  /// The newest value, while is_known().
  [[nodiscard]] float newest() const { return value_; }
  /// Between the last two readings, ns; nothing before there were two.
  [[nodiscard]] std::optional<Nanoseconds> interval() const {
    return interval_ > 0 ? std::optional(interval_) : std::nullopt;
  }
  /// What holds at `time`, and since when.
  [[nodiscard]] std::optional<MinMaxSeries::Reading> at(Nanoseconds time) const;

 private:
  MinMaxSeries series_;
  /// What is known by a reading of how often there is one.
  void measure(Nanoseconds time);

  Nanoseconds heard_ = 0, longest_ = 0, interval_ = 0;
  Nanoseconds seldom_ = 0;  // the interval before, where it was too long; 0: it was not
  Nanoseconds shown_until_ = INT64_MAX;
  float value_ = 0;
  bool known_ = false, expired_ = false;
};

}  // namespace syncline
