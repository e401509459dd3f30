// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "channels/cycle_sample.h"
#include "trace/signals.h"

namespace syncline {

/// What of a sample is recorded: everything that the others of its signals are made of.
[[nodiscard]] std::span<const Signal> sample_columns();

/// Puts a recorded cell of one of them back. Which of the values are valid say the flags; those that are not, and were
/// not recorded, stay as they are.
using PutCell = void (*)(CycleSample&, const SignalNumber&);
[[nodiscard]] PutCell cell_writer(Signal column);

}  // namespace syncline
