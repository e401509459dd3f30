// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

#include "record/run_record.h"

namespace syncline::ui {

/// A signal of the bus, or that of one slave or of one variable.
struct SignalSource {
  Signal signal = Signal::kDeviation;
  std::size_t slave = 0;  // or the variable's number in the run, see WatchLists
  bool operator==(const SignalSource&) const = default;
};

/// The run has such a slave or variable, where it is one of these.
[[nodiscard]] bool isThere(const RunRecord& record, const SignalSource& source);
/// The run must have it.
[[nodiscard]] const MinMaxSeries& seriesOf(const RunRecord& record, const SignalSource& source);
/// "Largest deviation", "#1 Servo" (its deviation), "#1 Servo: Arrival phase", a variable's name.
[[nodiscard]] QString nameOf(const RunRecord& record, const SignalSource& source);
/// Head of a CSV column: "deviation_ns", "deviation_ns #1", a variable's name.
[[nodiscard]] std::string keyOf(const RunRecord& record, const SignalSource& source);
/// The magnitude that the signal is held against, in its unit; 0: none.
[[nodiscard]] double limitOf(const RunLimits& limits, Signal signal);
/// It has no sign: what swings about zero is seen at half its period.
[[nodiscard]] bool isMagnitude(Signal signal);

}  // namespace syncline::ui
