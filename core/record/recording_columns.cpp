// SPDX-License-Identifier: Apache-2.0
// Single columns of a recording, for who needs some of it and not its samples.
#include <algorithm>
#include <string_view>

#include "reasons/because.h"
#include "record/recording_reader.h"
#include "record/sample_columns.h"

namespace syncline {

Status RecordingReader::unread(const Block& block, std::int64_t series) const {
  const auto signal = static_cast<std::size_t>(series % kBusSeries);
  const auto key = signal < kSignalCount ? signals()[signal].key : std::string_view("a signal");
  return damaged_recording(database_, because("{signal} of block {number} cannot be read", key, block.number));
}

Result<SqlTransaction> RecordingReader::hold() {
  auto held = SqlTransaction::begin_reading(database_);
  if (!held) return read_error(database_, held.error());
  return held;
}

Status RecordingReader::ranges(const Block& block, std::span<const Signal> columns, std::span<Range> out) {
  std::ranges::fill(out, Range{});
  if (columns.empty()) return {};
  // What lies between them costs less than to look for each.
  auto row = database_.prepare(select_rows("summary", version_, "WHERE id >= ? AND id < ?"));
  if (!row) return read_error(database_, row.error());
  const auto first = block.number * kSeriesPerBlock;
  row->bind(0, first).bind(1, first + kSeriesPerBlock);
  std::int64_t rows = 0;
  bool whole = true;
  const auto status = row->each([&] {
    ++rows;
    if (row->integer(kSummaryCheck) == 0) {
      note_row("summary", *row);
      whole = false;
    }
    // Several pictures may be asked for at once, of the same signal.
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (row->integer(kSummaryId) - first != series_number(columns[i])) continue;
      out[i] = {static_cast<float>(row->real(kSummaryMin)), static_cast<float>(row->real(kSummaryMax))};
    }
  });
  if (!status) return read_error(database_, status.error());
  if (whole && (block.sums < 0 || rows == block.sums)) return {};
  return unread(block, series_number(columns.front()));
}

Status RecordingReader::read_levels(const Block& block, std::int64_t series, std::vector<Range>& out) {
  out.clear();
  auto row = database_.prepare(select_levels(version_));
  if (!row) return read_error(database_, row.error());
  row->bind(0, block.number * kSeriesPerBlock + series);
  const auto buckets = (static_cast<std::size_t>(block.cycles) + kLevelCycles - 1) / kLevelCycles;
  std::vector<float> pairs;
  bool good = false;
  const auto status = row->each([&] {
    good = row->integer(2) != 0 && decode_floats(row->blob(1), 2 * buckets, pairs);
    for (std::size_t i = 0; good && i < buckets; ++i) {
      // Comparisons with not-a-number are false: an empty one stays empty.
      out.emplace_back();
      if (pairs[2 * i] <= pairs[2 * i + 1]) out.back() = {pairs[2 * i], pairs[2 * i + 1]};
    }
  });
  if (!status) return read_error(database_, status.error());
  return good ? Status{} : unread(block, series);
}

Result<bool> RecordingReader::is_whole(const Block& block) {
  if (!salvaged_) return true;
  const auto first = block.number * kSeriesPerBlock;
  auto columns = database_.prepare("SELECT count(*) FROM data WHERE id >= ? AND id < ? AND codec > 0");
  if (!columns) return read_error(database_, columns.error());
  columns->bind(0, first).bind(1, first + kSeriesPerBlock);
  bool whole = true;
  const auto counted = columns->each([&] { whole = columns->integer(0) == block.columns; });
  if (!counted) return read_error(database_, counted.error());
  return whole;
}

Status RecordingReader::cells(const Block& block, Signal column, ColumnCells& out) {
  auto row = database_.prepare(select_rows("data", version_, "WHERE id = ?"));
  if (!row) return read_error(database_, row.error());
  const auto series = series_number(column);
  row->bind(0, block.number * kSeriesPerBlock + series);
  bool good = false;
  const auto status = row->each([&] {
    good = row->integer(kDataCheck) != 0 && row->integer(kDataCount) == block.cycles &&
           decode_column(static_cast<ColumnCodec>(row->integer(kDataCodec)), row->blob(kDataCells),
                         static_cast<std::size_t>(block.cycles), out);
  });
  if (!status) return read_error(database_, status.error());
  return good ? Status{} : unread(block, series);
}

}  // namespace syncline
