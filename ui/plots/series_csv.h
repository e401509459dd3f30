// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trace/min_max_series.h"

namespace syncline::ui {

/// A column of a table of series; the name carries the unit.
struct CsvColumn {
  std::string name;
  const MinMaxSeries* series = nullptr;
};

/// "2026-03-01T12:00:00.000000125Z" of a time since 2000-01-01.
[[nodiscard]] std::string iso_utc(Nanoseconds time);

/// The number of the latest cycle at or before a time; empty: none is known.
using CycleAt = std::function<std::optional<std::uint64_t>(Nanoseconds)>;

/// Samples in [begin, end) of all columns, merged by time: `time_ns` since `origin`, `time_utc`, `cycle`, then one
/// value a column. No value and not-a-number are empty fields. Independent of the locale; text fields
/// that need it are quoted.
[[nodiscard]] std::string series_csv(const std::vector<CsvColumn>& columns, const CycleAt& cycle_at, Nanoseconds origin,
                                     Nanoseconds begin, Nanoseconds end);

}  // namespace syncline::ui
