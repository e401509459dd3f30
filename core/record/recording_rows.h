// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "support/result.h"

/// How rows of a recording are written with their check, and read with it (docs/recording.md): SQL texts.
namespace syncline {

class SqlDatabase;

/// Names of all tables.
[[nodiscard]] std::span<const std::string_view> recording_tables();
/// Names of the columns of a table, without its checks; of `data` without `levels`, which have a check of their own.
[[nodiscard]] std::string_view columns_of(std::string_view table);
[[nodiscard]] int column_count(std::string_view table);

/// Parameters as columns_of(); of `data` one more behind them, the levels.
[[nodiscard]] std::string insert_row(std::string_view table, bool replace = false);

/// Rows with columns_of() and, behind them, whether they are as they were written: 1 or 0. Of versions without checks
/// it is 1, and columns that they lack are NULL, counts of rows -1. `tail`: WHERE, ORDER BY.
[[nodiscard]] std::string select_rows(std::string_view table, std::int64_t version, std::string_view tail = {});
/// Places in a row of select_rows() of these two.
enum DataColumn { kDataId, kDataCodec, kDataCount, kDataTimes, kDataCells, kDataCheck };
enum SummaryColumn { kSummaryId, kSummaryCount, kSummaryMin, kSummaryMax, kSummaryLast, kSummaryCheck };
/// "id", "levels", and whether they are as they were written.
[[nodiscard]] std::string select_levels(std::int64_t version, std::string_view tail = "WHERE id = ?");

/// How many rows each table has: without it nobody sees that some are gone. A value: what was counted in a transaction
/// that comes to nothing is taken back with it.
class RowTally {
 public:
  static constexpr std::int64_t kTables = 12;  // of_all()
  /// Of all tables but `data` and `summary`, whose rows each block counts: all empty.
  [[nodiscard]] static RowTally of_all();
  void add(std::string_view table, std::int64_t rows = 1) { rows_[std::string(table)] += rows; }
  /// Of a table whose rows are replaced by their keys.
  void put(std::string_view table, std::string_view key);
  void clear(std::string_view table) { rows_[std::string(table)] = 0; }
  [[nodiscard]] Status write(SqlDatabase& database) const;

 private:
  std::map<std::string, std::int64_t> rows_;
  std::set<std::string> keys_;
};

}  // namespace syncline
