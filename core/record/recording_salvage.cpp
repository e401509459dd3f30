// SPDX-License-Identifier: Apache-2.0
#include "record/recording_salvage.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "record/column_codec.h"
#include "record/recording_rows.h"
#include "record/recording_schema.h"
#include "record/sample_columns.h"
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

/// A table that a row of so many values may be of, and what takes it in.
struct Taker {
  std::string_view table;
  std::size_t width = 0;
  SqlStatement insert;
};

Result<std::vector<Taker>> takers_into(SqlDatabase& database) {
  std::vector<Taker> takers;
  for (const auto table : recording_tables()) {
    auto insert = database.prepare(insert_checked(table));
    if (!insert) return tl::unexpected(insert.error());
    takers.push_back({table, width_of(table), *insert});
  }
  return takers;
}

Status take_rows(TornDatabase& torn, SqlDatabase& database) {
  auto takers = takers_into(database);
  if (!takers) return tl::unexpected(takers.error());
  Status status;
  torn.rows([&](std::int64_t id, std::span<const TornValue> row) {
    for (auto& taker : *takers) {
      if (!status || taker.width != row.size()) continue;
      bind(taker.insert, taker.table, id, row);
      status = taker.insert.run();
    }
    return status.has_value();
  });
  return status;
}

/// Of a block whose own row is gone: what it says of its rows, by these.
struct BlockRows {
  std::int64_t number = 0, columns = 0, held = 0, sums = 0;
};

/// Pages lie in the order in which they were begun. Of a file that is cut off, a block behind which another whole one
/// lay at least in part has all its rows, but for those that could not be read: none that has a sum may be missing.
Result<std::vector<BlockRows>> blocks_without_row(SqlDatabase& database) {
  std::string summed;
  for (const auto signal : sample_columns()) summed += fmt::format("{},", static_cast<int>(signal));
  auto rows = database.prepare(fmt::format(
      "SELECT id / {0}, sum(codec > 0), sum(codec = 0), "
      "(SELECT count(*) FROM summary s WHERE s.id >= d.id / {0} * {0} AND s.id < (d.id / {0} + 1) * {0}) FROM data d "
      "WHERE NOT EXISTS(SELECT 1 FROM block b WHERE b.number = d.id / {0}) "
      "AND id / {0} + 1 < (SELECT max(id) / {0} FROM data) GROUP BY d.id / {0} "
      "HAVING NOT EXISTS(SELECT 1 FROM summary s WHERE s.id >= d.id / {0} * {0} AND s.id < (d.id / {0} + 1) * {0} "
      "AND (s.id % {0} IN ({1}{3}) OR s.id % {2} = {3}) AND NOT EXISTS(SELECT 1 FROM data e WHERE e.id = s.id)) "
      "ORDER BY d.id / {0}",
      kSeriesPerBlock, summed, kBusSeries, static_cast<int>(Signal::kVariable)));
  if (!rows) return tl::unexpected(rows.error());
  std::vector<BlockRows> blocks;
  const auto status = rows->each([&] {
    blocks.push_back({rows->integer(0), rows->integer(1), rows->integer(2), rows->integer(3)});
  });
  if (!status) return tl::unexpected(status.error());
  return blocks;
}

/// The cells of a column of integers; nothing where it is not there, or lacks a cell.
Result<std::vector<std::int64_t>> integers_of(SqlDatabase& database, std::int64_t block, Signal column) {
  auto row = database.prepare("SELECT codec, count, cells FROM data WHERE id = ?");
  if (!row) return tl::unexpected(row.error());
  row->bind(0, block * kSeriesPerBlock + series_number(column));
  ColumnCells cells;
  const auto status = row->each([&] {
    const auto count = std::clamp<std::int64_t>(row->integer(1), 0, kMostBlockCycles);
    const auto codec = static_cast<ColumnCodec>(row->integer(0));
    if (!decode_column(codec, row->blob(2), static_cast<std::size_t>(count), cells) || !cells.there.empty()) cells = {};
  });
  if (!status) return tl::unexpected(status.error());
  return std::move(cells.integers);
}

/// The row of a block lies on a page that may have been moved to the end of what was written then.
Status write_blocks_again(SqlDatabase& database) {
  const auto blocks = blocks_without_row(database);
  if (!blocks) return tl::unexpected(blocks.error());
  auto insert = database.prepare(insert_row("block"));
  if (!insert) return tl::unexpected(insert.error());
  for (const auto& block : *blocks) {
    const auto cycles = integers_of(database, block.number, Signal::kCycle);
    if (!cycles) return tl::unexpected(cycles.error());
    const auto times = integers_of(database, block.number, Signal::kSendTime);
    if (!times) return tl::unexpected(times.error());
    if (cycles->empty() || cycles->size() != times->size()) continue;
    const std::int64_t values[] = {block.number,  cycles->front(), cycles->back(), std::ssize(*cycles), times->front(),
                                   times->back(), block.columns,   block.held,     block.sums};
    for (int i = 0; i < static_cast<int>(std::size(values)); ++i) insert->bind(i, values[i]);
    if (auto status = insert->run(); !status) return status;
  }
  return {};
}

/// Blocks without any value are told together, and not each as a gap.
Status count_blocks(SalvagedRecording& salvaged) {
  auto& database = salvaged.database;
  const auto empty = fmt::format(
      "DELETE FROM block WHERE NOT EXISTS(SELECT 1 FROM data WHERE id >= number * {0} AND id < (number + 1) * {0})",
      kSeriesPerBlock);
  const auto before = database.number("SELECT count(*) FROM block");
  auto status = database.execute(empty.c_str());
  const auto blocks = database.number("SELECT count(*) FROM block");
  const auto cycles =
      database.number(fmt::format("SELECT sum(cycles) FROM block WHERE columns = (SELECT count(*) FROM data "
                                  "WHERE id >= number * {0} AND id < (number + 1) * {0} AND codec > 0)",
                                  kSeriesPerBlock));
  const auto counted = database.number("SELECT count FROM tally WHERE name = 'block'");
  for (const auto* number : {&before, &blocks, &cycles, &counted}) {
    if (status && !*number) status = tl::unexpected(number->error());
  }
  if (!status) return status;
  salvaged.cycles = static_cast<std::uint64_t>(*cycles);
  salvaged.blocks_lost = static_cast<std::uint64_t>(std::max(*before, *counted) - *blocks);
  // Counted again by who reads it: what is lost is told already.
  auto tally = database.prepare(insert_row("tally", true));
  if (!tally) return tl::unexpected(tally.error());
  return tally->bind(0, std::string_view("block")).bind(1, *blocks).run();
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
  if (status && salvaged.bytes_said > 0) status = write_blocks_again(salvaged.database);
  if (status) status = count_blocks(salvaged);
  if (status) status = salvaged.database.execute("COMMIT");
  if (!status) return read_error(salvaged.database, status.error());
  return salvaged;
}

}  // namespace syncline
