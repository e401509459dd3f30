// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "ui/plots/value_axis.h"

namespace syncline {
class RunRecord;
struct SignalInfo;
}  // namespace syncline

/// What plots need to know of the signals of a view, whether the run at hand has them or not.
namespace syncline::ui {

/// "#1 Servo: Deviation", "Drift", a variable's name; of what the run lacks what is known of it: "1003: AL state".
[[nodiscard]] QString nameOf(const RunRecord& record, const ViewSignal& signal);
/// Of whom: "#1 Servo"; empty for the bus and variables.
[[nodiscard]] QString ownerOf(const RunRecord& record, const ViewSignal& signal);
/// Of what: "Deviation", "Port 0: lost links /s".
[[nodiscard]] QString quantityOf(const ViewSignal& signal);
/// "ns", "ppm", "1/s" of a rate; "" of counts, states and variables.
[[nodiscard]] QString unitOf(const ViewSignal& signal);
/// It has no curve: a band.
[[nodiscard]] bool isState(const ViewSignal& signal);
/// It can be shown as a rate.
[[nodiscard]] bool isCount(const ViewSignal& signal);
/// The row of the table; null for variables and what this program does not know.
[[nodiscard]] const SignalInfo* rowOf(const ViewSignal& signal);
/// The axis for signals that share it; none: what an empty plot has.
[[nodiscard]] ValueAxis::Options axisFor(const std::vector<const ViewSignal*>& signals);
/// A value in words.
[[nodiscard]] QString valueOf(const ViewSignal& signal, double value);

}  // namespace syncline::ui
