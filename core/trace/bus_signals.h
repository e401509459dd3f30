// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "channels/cycle_sample.h"
#include "trace/signal_table.h"

namespace syncline {

/// Puts the rows of the bus into the table of signals.
void put_bus_signals(SignalTable& table);

/// What SignalInfo::of_cycle gives for each of the samples, as it is drawn; not-a-number where the cycle has none.
/// `out` has room for as many.
using CycleValues = void (*)(std::span<const CycleSample>, float* out);
/// Of a signal that a sample tells of; null for the others.
[[nodiscard]] CycleValues cycle_values(Signal signal);

}  // namespace syncline
