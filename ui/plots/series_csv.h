// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "support/types.h"

namespace syncline {
class MinMaxSeries;
}  // namespace syncline

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

/// Some rows of a table, as numbers: they can be made words of in any thread.
struct CsvRows {
  std::vector<Nanoseconds> times;
  std::vector<std::optional<std::uint64_t>> cycles;
  std::vector<float> values;  // row by row; not-a-number: none
  Nanoseconds origin = 0;
};

/// The samples of [begin, end) of all columns, merged by time, a portion at a time: however long the range is, only a
/// portion is in memory. The series must stay; what leaves them before it was taken is missing.
class CsvTable {
 public:
  CsvTable(std::vector<CsvColumn> columns, CycleAt cycle_at, Nanoseconds origin, Nanoseconds begin, Nanoseconds end);
  /// `time_ns` since `origin`, `time_utc`, `cycle`, then one value a column; text fields that need it are quoted.
  [[nodiscard]] std::string head() const;
  /// The next rows, of about so many values together.
  [[nodiscard]] CsvRows next(std::size_t values);
  [[nodiscard]] bool complete() const { return next_ >= end_; }
  /// Thousandths of the range.
  [[nodiscard]] int progress() const;

 private:
  std::vector<CsvColumn> columns_;
  CycleAt cycle_at_;
  Nanoseconds origin_, begin_, next_, end_;
};

/// Behind `out`, a line a row. No value is an empty field. Independent of the locale.
void append_csv(std::string& out, const CsvRows& rows);

/// The whole table at once.
[[nodiscard]] std::string series_csv(CsvTable table);

}  // namespace syncline::ui
