// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "channels/values/stamp_source.h"
#include "trace/sample_store.h"
#include "trace/signals.h"

/// What one has to know of a signal before one believes it: how often it is read, how old its newest reading is, by
/// which clock, who stamped the moment, and by how much both may be off.
namespace syncline {

/// The local clocks of ESCs count in steps of this (100 MHz; ESC data sheet I, 9.1), ns.
inline constexpr Nanoseconds kSlaveClockStep = 10;
/// Over so much of the run before a moment its rate and its doubts are taken.
inline constexpr Nanoseconds kQualitySpan = kSecond;

struct SignalQuality {
  /// Readings a second that had a value; nothing where only changes are known, as of counts in a recording.
  std::optional<double> rate;
  std::optional<Nanoseconds> age;  // of the newest reading
  SignalInfo::Clock clock = SignalInfo::Clock::kNone;
  /// The value is wrong by no more, ns; nothing where it is no time, or nobody knows.
  std::optional<Nanoseconds> value_doubt;
  StampSource stamped_by = StampSource::kUntold;
  /// Its moment is wrong by no more: stamps and, of what is read now and then, the time between two readings.
  std::optional<Nanoseconds> time_doubt;
  bool operator==(const SignalQuality&) const = default;
};

/// Of a signal that is drawn, of the bus, a slave or a variable, at `time` (host clock) of the run. Looks at each
/// sample of kQualitySpan; what is derived is not made for it.
[[nodiscard]] SignalQuality quality_of(const SampleStore& store, Signal signal, std::size_t slave, Nanoseconds time);

/// By how much a value of that clock is off at most, where stamps are off by `stamps`.
[[nodiscard]] std::optional<Nanoseconds> value_doubt(const SignalInfo& signal, std::optional<Nanoseconds> stamps);

/// Names in JSON: "software", "kernel", "adapter", "capture", "probe", "untold".
[[nodiscard]] std::string_view name_of(StampSource source);
/// The same: "none", "host", "slaves", "both".
[[nodiscard]] std::string_view name_of(SignalInfo::Clock clock);

}  // namespace syncline
