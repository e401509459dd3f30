// SPDX-License-Identifier: Apache-2.0
#include "record/recording_salvage.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "record/recording_rows.h"
#include "record/recording_schema.h"
#include "sqlite/torn_database.h"

namespace syncline {
namespace {

/// Columns of a table with its checks, as many as a row of it has values.
std::size_t width_of(std::string_view table) {
  return static_cast<std::size_t>(column_count(table)) + (table == "data" ? 3 : 1);
}

/// Takes a row into a table where its check is that of this table.
std::string insert_checked(std::string_view table) {
  const auto columns = columns_of(table);
  std::string values;
  for (int i = 1; i <= column_count(table); ++i) values += fmt::format("{}?{}", i == 1 ? "" : ", ", i);
  const auto next = column_count(table) + 1;
  if (table == "data") {
    return fmt::format(
        "INSERT OR REPLACE INTO data({0}, levels, crc, levels_crc) SELECT {1}, ?{2}, ?{3}, ?{4} "
        "WHERE row_crc('data', {1}) = ?{3}",
        columns, values, next, next + 1, next + 2);
  }
  return fmt::format("INSERT OR REPLACE INTO {0}({1}, crc) SELECT {2}, ?{3} WHERE row_crc('{0}', {2}) = ?{3}", table,
                     columns, values, next);
}

/// A whole number in a column of reals lies there as an integer.
bool is_real(std::string_view table, int column) { return table == "summary" && column >= 2 && column <= 4; }

void bind(SqlStatement& statement, std::string_view table, std::int64_t id, std::span<const TornValue> row) {
  using Kind = TornValue::Kind;
  for (int i = 0; i < static_cast<int>(row.size()); ++i) {
    const auto& value = row[static_cast<std::size_t>(i)];
    if (value.kind == Kind::kNull && i == 0) {
      statement.bind(i, id);
    } else if (value.kind == Kind::kNull) {
      statement.bind_null(i);
    } else if (value.kind == Kind::kText) {
      statement.bind(i, value.bytes);
    } else if (value.kind == Kind::kBlob) {
      statement.bind_blob(i, value.bytes);
    } else if (value.kind == Kind::kReal || is_real(table, i)) {
      statement.bind_real(i, value.kind == Kind::kReal ? value.real : static_cast<double>(value.integer));
    } else {
      statement.bind(i, value.integer);
    }
  }
}

Status take_rows(TornDatabase& torn, SqlDatabase& database) {
  Status status;
  torn.rows([&](std::int64_t id, std::span<const TornValue> row) {
    for (const auto table : recording_tables()) {
      if (!status || width_of(table) != row.size()) continue;
      auto statement = database.prepare(insert_checked(table));
      if (statement) bind(*statement, table, id, row);
      status = statement ? statement->run() : Status(tl::unexpected(statement.error()));
    }
    return status.has_value();
  });
  return status;
}

/// Blocks without any value are told together, and not each as a gap.
Status leave_out_empty(SalvagedRecording& salvaged) {
  auto& database = salvaged.database;
  const auto empty = fmt::format(
      "FROM block WHERE NOT EXISTS(SELECT 1 FROM data WHERE id >= number * {0} AND id < (number + 1) * {0})",
      kSeriesPerBlock);
  auto sums =
      database.prepare("SELECT count(*), min(first_cycle), max(last_cycle), min(begin_ns), max(end_ns) " + empty);
  if (!sums) return tl::unexpected(sums.error());
  auto status = sums->each([&] {
    salvaged.blocks = static_cast<std::uint64_t>(sums->integer(0));
    salvaged.first_cycle = sums->integer(1);
    salvaged.last_cycle = sums->integer(2);
    salvaged.begin = sums->integer(3);
    salvaged.end = sums->integer(4);
  });
  if (status) status = database.execute(("DELETE " + empty).c_str());
  return status;
}

}  // namespace

Result<SalvagedRecording> salvage_recording(const std::string& path) {
  auto torn = TornDatabase::open(path);
  if (!torn) return tl::unexpected(torn.error());
  const bool has_checks = torn->user_version() >= kFirstWithChecks && torn->user_version() <= kRecordingVersion;
  if (torn->application_id() != kRecordingId || !has_checks)
    return fail(Error{.code = ErrorCode::kFileNotReadable, .file = path});
  auto database = create_salvage(path);
  if (!database) return tl::unexpected(database.error());
  SalvagedRecording salvaged{.database = std::move(*database), .bytes = torn->bytes()};
  if (torn->bytes_said() > torn->bytes()) salvaged.bytes_said = torn->bytes_said();
  auto status = salvaged.database.execute("BEGIN");
  if (status) status = take_rows(*torn, salvaged.database);
  if (status) status = leave_out_empty(salvaged);
  if (status) status = salvaged.database.execute("COMMIT");
  if (!status) return read_error(salvaged.database, status.error());
  return salvaged;
}

}  // namespace syncline
