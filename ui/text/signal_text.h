// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "trace/signals.h"

namespace syncline::ui {

/// Name of a signal that has a value of its own in every cycle or reading, as a distribution needs it; empty for counts
/// and states.
[[nodiscard]] QString signalText(Signal signal);
/// Name of any signal that is drawn, counts and states too; empty for cells.
[[nodiscard]] QString signalName(Signal signal);
/// A value in words: "+250 ns", "1.25 ppm", "12", and of states their names.
[[nodiscard]] QString signalValue(Signal signal, double value);

}  // namespace syncline::ui
