// SPDX-License-Identifier: Apache-2.0
#include "record/recording_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "record/recording_schema.h"
#include "sqlite/sqlite_database.h"

namespace syncline {
namespace {

struct Table {
  std::string_view name, columns;
};

constexpr Table kAllTables[] = {
    {"meta", "key, value"},
    {"document", "kind, name, body"},
    {"limits", "key, value, unit"},
    {"slave", "position, name, vendor_id, product_code, revision_no"},
    {"signal", "id, key, name, unit, scope, form, source, since"},
    {"series", "id, signal, slave"},
    {"variable", "id, name, slave, direction, data_type, bit_offset, bit_size, series"},
    {"watch_list", "number, place, variable"},
    {"block", "number, first_cycle, last_cycle, cycles, begin_ns, end_ns, columns, held, sums"},
    {"summary", "id, count, min, max, last"},
    {"data", "id, codec, count, times, cells"},
    {"event", "id, time_ns, slave, kind, text, details"},
    {"finding", "id, code, level, slave, text, details"},
    {"note", "id, time_ns, text"},
    {"tally", "name, count"},
};

/// "?1, ?2" from the first parameter to the last.
std::string parameters(int first, int last) {
  std::string text;
  for (int i = first; i <= last; ++i) text += fmt::format("{}?{}", i == first ? "" : ", ", i);
  return text;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), with);
  return text;
}

}  // namespace

std::span<const std::string_view> recording_tables() {
  static const auto kNames = [] {
    std::array<std::string_view, std::size(kAllTables)> names;
    std::ranges::transform(kAllTables, names.begin(), &Table::name);
    return names;
  }();
  return kNames;
}

std::string_view columns_of(std::string_view table) {
  const auto* const found = std::ranges::find(kAllTables, table, &Table::name);
  return found == std::end(kAllTables) ? std::string_view{} : found->columns;
}

int column_count(std::string_view table) { return static_cast<int>(std::ranges::count(columns_of(table), ',')) + 1; }

std::string insert_row(std::string_view table, bool replace) {
  const auto columns = columns_of(table);
  const int count = column_count(table);
  const auto values = parameters(1, count);
  const auto verb = replace ? "INSERT OR REPLACE" : "INSERT";
  if (table == "data") {
    return fmt::format(
        "{0} INTO data({1}, levels, crc, levels_crc) VALUES({2}, ?{3}, row_crc('data', {2}), "
        "row_crc('levels', ?1, ?{3}))",
        verb, columns, values, count + 1);
  }
  return fmt::format("{0} INTO {1}({2}, crc) VALUES({3}, row_crc('{1}', {3}))", verb, table, columns, values);
}

std::string select_rows(std::string_view table, std::int64_t version, std::string_view tail) {
  std::string columns(columns_of(table));
  if (version >= kFirstWithChecks)
    return fmt::format("SELECT {1}, row_crc('{0}', {1}) = crc FROM {0} {2}", table, columns, tail);
  columns = replaced(std::move(columns), "held, sums", "-1, -1");
  if (version < kFirstWithDetails) columns = replaced(std::move(columns), "details", "NULL");
  return fmt::format("SELECT {1}, 1 FROM {0} {2}", table, columns, tail);
}

std::string select_levels(std::int64_t version, std::string_view tail) {
  return fmt::format("SELECT id, levels, {} FROM data {}",
                     version >= kFirstWithChecks ? "row_crc('levels', id, levels) = levels_crc" : "1", tail);
}

RowTally RowTally::of_all() {
  RowTally tally;
  for (const auto& table : kAllTables) {
    if (table.name != "data" && table.name != "summary" && table.name != "tally") tally.clear(table.name);
  }
  return tally;
}

void RowTally::put(std::string_view table, std::string_view key) {
  if (keys_.insert(fmt::format("{}/{}", table, key)).second) add(table);
}

Status RowTally::write(SqlDatabase& database) const {
  auto row = database.prepare(insert_row("tally", true));
  if (!row) return tl::unexpected(row.error());
  for (const auto& [table, count] : rows_) {
    if (auto status = row->bind(0, table).bind(1, count).run(); !status) return status;
  }
  return {};
}

}  // namespace syncline
