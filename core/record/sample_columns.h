// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "channels/cycle_sample.h"
#include "record/column_codec.h"
#include "trace/signals.h"

namespace syncline {

/// What of a sample is recorded: everything that the others of its signals are made of.
[[nodiscard]] std::span<const Signal> sample_columns();

/// Puts the recorded cells of one of them back, as many as there are samples. Which of the values are valid say the
/// flags; those that are not, and were not recorded, stay as they are.
using PutColumn = void (*)(std::span<CycleSample>, const ColumnCells&);
/// By the number of the signal (series_number()); null when it is none of them.
[[nodiscard]] PutColumn column_writer(std::int64_t signal);

}  // namespace syncline
