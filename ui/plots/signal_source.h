// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>

#include "trace/signals.h"

namespace syncline {
class MinMaxSeries;
struct RunLimits;
class RunRecord;
struct ViewSignal;
}  // namespace syncline

namespace syncline::ui {

/// A signal of the bus, or that of one slave or of one variable.
struct SignalSource {
  Signal signal = Signal::kDeviation;
  std::size_t slave = 0;  // or the variable's number in the run, see WatchLists
  bool operator==(const SignalSource&) const = default;
};

/// By which a view knows the slave: its station address; of a run that tells none the one that it would have had.
[[nodiscard]] std::uint16_t stationOf(const RunRecord& record, std::size_t slave);
/// The slave with that station address; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> slaveOf(const RunRecord& record, std::uint16_t station);
/// What a view means in this run; nothing where it has no such signal, slave or variable.
[[nodiscard]] std::optional<SignalSource> sourceOf(const RunRecord& record, const ViewSignal& signal);
/// What a view says of it; the run must have it.
[[nodiscard]] ViewSignal viewSignalOf(const RunRecord& record, const SignalSource& source);

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
/// Magnitudes of all slaves in one, or-ed on the wire: no slave need have had one, and none had a larger one.
[[nodiscard]] bool isUpperEstimate(const RunRecord& record, Signal signal);

}  // namespace syncline::ui
