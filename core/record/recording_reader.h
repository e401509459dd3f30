// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "channels/cycle_sample.h"
#include "findings/finding.h"
#include "record/column_codec.h"
#include "record/recording.h"
#include "record/recording_rows.h"
#include "record/recording_salvage.h"
#include "record/recording_schema.h"
#include "record/run_note.h"
#include "sqlite/sqlite_database.h"

namespace syncline {

/// A recording as a whole, without its samples.
struct RecordingInfo {
  RecordingAbout about;
  std::optional<std::string> ended;  // why; nothing: the program was killed, and it is whole up to its last block
  std::uint64_t blocks = 0, cycles = 0;
  std::uint64_t missing_cycles = 0;  // between the first and the last one
  Nanoseconds begin = 0, end = 0;    // host clock, of the first and the last sample
  std::vector<RecordedEvent> events;
  std::vector<RecordedFinding> findings;
  std::vector<RunNote> notes;
};

/// Sums of one signal over one block.
struct BlockSummary {
  Nanoseconds begin = 0, end = 0;
  std::int64_t count = 0;  // of values
  double min = 0, max = 0, last = 0;
};

/// Reads a recording, also one that is being written. What is damaged is told, not guessed: rows that are not as they
/// were written are left out, cycles that need one of them are a gap, and damage() names them. Without them nothing can
/// be read (limits, lists of variables) is kFileNotReadable. Of a file that SQLite refuses, as it is cut off or a page
/// of SQLite's own is damaged, whatever is whole is read (salvage_recording()), and found() says how much is lost;
/// where that is no cycle it is kFileNotReadable. For one thread.
class RecordingReader {
 public:
  /// As open_recording(), and kFileNotReadable.
  [[nodiscard]] static Result<RecordingReader> open(const std::string& path);

  [[nodiscard]] const std::string& path() const { return database_.path(); }
  /// What was found about the file by all that was read so far, each row once: code "recording-damaged".
  [[nodiscard]] const std::vector<Finding>& damage() const { return damage_; }
  /// False: older programs wrote no checks, and what is damaged may not be seen.
  [[nodiscard]] bool is_checked() const { return version_ >= kFirstWithChecks; }
  /// One of damage(), for who cannot do without: kFileNotReadable.
  [[nodiscard]] Status as_error(const Finding& damage) const;
  /// All that was found about the file: damage() so far and, once info() was read, a log that is missing, rows without
  /// checks.
  [[nodiscard]] std::vector<Finding> found() const;
  /// Its findings are those of the run and, behind them, found().
  [[nodiscard]] Result<RecordingInfo> info();
  /// All samples in their order, a block at a time, until `take` returns false.
  [[nodiscard]] Status samples(const std::function<bool(std::span<const CycleSample>)>& take);
  /// A stretch of cycles as it was written, about a second.
  struct Block {
    std::int64_t number = 0, first_cycle = 0, last_cycle = 0, cycles = 0;
    Nanoseconds begin = 0, end = 0;  // host clock, of its first and its last cycle
    std::int64_t columns = 0;
    std::int64_t held = -1, sums = -1;  // rows of `data` that are no columns, and of `summary`; -1: not told
  };
  /// All of them, in the order in which they were written.
  [[nodiscard]] Result<std::vector<Block>> blocks();
  /// The samples of one; none where it is damaged, see damage().
  [[nodiscard]] Status samples(const Block& block, std::vector<CycleSample>& out) { return read_block(block, out); }
  /// A signal over the whole recording, a row a block that has any value of it; of a slave or a variable, or of the bus
  /// with -1.
  [[nodiscard]] Result<std::vector<BlockSummary>> overview(Signal signal, int slave = -1);
  /// Values of slaves' counts and states, and of totals: when they changed; not-a-number where nothing is known.
  struct Points {
    std::vector<Nanoseconds> times;
    std::vector<float> values;
  };
  [[nodiscard]] Result<Points> points(Signal signal, int slave = -1);
  /// For who reads many small things: while it lives all of them are of one state of the file. Neither samples() nor
  /// another one within it; the reader stays where it is.
  [[nodiscard]] Result<SqlTransaction> hold();
  /// What a column of samples (sample_columns()) shows of a stretch of cycles, as it is drawn; min > max: nothing.
  struct Range {
    float min = std::numeric_limits<float>::infinity(), max = -std::numeric_limits<float>::infinity();
    bool operator==(const Range&) const = default;
    [[nodiscard]] bool empty() const { return min > max; }
    [[nodiscard]] bool holds(const Range& other) const { return min <= other.min && other.max <= max; }
    void take(const Range& other) {
      min = std::min(min, other.min);
      max = std::max(max, other.max);
    }
  };
  /// Of each of the signals, which have a value in every cycle, over one block; out of its sums.
  [[nodiscard]] Status ranges(const Block& block, std::span<const Signal> columns, std::span<Range> out);
  /// Of each kLevelCycles cycles of a block, the last of fewer; kFileNotReadable, too, where it has no such column.
  [[nodiscard]] Status ranges(const Block& block, Signal column, std::vector<Range>& out) {
    return read_levels(block, series_number(column), out);
  }
  /// The cells of one block, one a cycle; kFileNotReadable, too, where it has no such column.
  [[nodiscard]] Status cells(const Block& block, Signal column, ColumnCells& out);
  /// Whether all of its columns were found, where the file is read page by page: rows that were found are as they were
  /// written. True of any other file: what is damaged in it is seen by who reads the samples.
  [[nodiscard]] Result<bool> is_whole(const Block& block);
  using AllPoints = std::map<std::int64_t, Points>;  // by series_number()
  /// The samples of one block, and what it has of points() of counts and states behind what is there.
  [[nodiscard]] Status samples(const Block& block, std::vector<CycleSample>& out, AllPoints& points) {
    return read_block(block, out, &points);
  }
  /// As samples(), and in the same pass points() of all counts and states, whatever the number of slaves.
  [[nodiscard]] Status samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints& points);
  /// Reads everything: the database's own check, the check of each row, all samples, each sum against its samples. The
  /// first thing that is wrong; the number of blocks that were read.
  [[nodiscard]] Result<std::uint64_t> verify();

 private:
  RecordingReader(SqlDatabase database, std::int64_t version, bool log_missing)
      : database_(std::move(database)), version_(version), log_missing_(log_missing) {}
  /// In the order in which they were written.
  Status blocks(const std::function<Status(const Block&)>& take);
  /// `points`: null where they are not wanted.
  Status read_block(const Block& block, std::vector<CycleSample>& out, AllPoints* points = nullptr);
  Status read_samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints* points);
  /// Whether all rows of it are there and as they were written; see damage() where not.
  Result<bool> read_rows(const Block& block, std::vector<CycleSample>& out, AllPoints* points);
  /// A row of `data` of a series that is no column.
  static bool read_points(const SqlStatement& row, Points& out);
  /// Not known from there on.
  static void forget(Points& points, Nanoseconds from);
  static void forget_all(AllPoints& points, Nanoseconds from);
  Status read_tally();
  /// All rows of `data` and `summary` with their checks.
  Status check_rows(const Block& block);
  /// By table and row; a row that is known already is not told again.
  void note(std::string table, std::string row, Finding finding);
  void note_row(std::string_view table, const SqlStatement& row);
  void note_gap(std::string_view table, std::string_view row, const Block& block);
  void note_series(std::string_view row, std::int64_t series, const Block& block);
  /// Whose rows are no block, `missing` of them because they are not there.
  void note_block(const Block& block, std::int64_t missing);
  /// `there`: how many there are of those that were counted.
  void note_missing(std::string_view table, std::int64_t there);
  /// For what cannot be without a row that is damaged: the first one.
  [[nodiscard]] Status damaged_row() const { return as_error(damage_.front()); }
  /// What cannot be decoded.
  [[nodiscard]] Status unread(const Block& block, std::int64_t series) const;
  Status read_levels(const Block& block, std::int64_t series, std::vector<Range>& out);
  Status check_sums(const Block& block, std::span<const CycleSample> samples);
  Status check_sum(const Block& block, std::int64_t series, std::string_view key, std::span<const float> values);
  /// Those of a column, where it has a value.
  Status check_levels(const Block& block, std::int64_t series, std::string_view key, std::span<const float> values);
  /// Which variables were watched; what there is by now.
  Status read_watched(WatchLists& watched);
  /// Whose column a series is, as a variable's number; nothing: of none that is known.
  [[nodiscard]] std::optional<std::size_t> variable_of(std::int64_t series) const;
  /// Reads the file page by page from now on; `otherwise` where it cannot be.
  Status salvage(Error otherwise);
  void note_cut(const SalvagedRecording& salvaged);
  [[nodiscard]] Result<RecordingInfo> read_info();
  Status read_about(RecordingInfo& info);
  Status read_told(RecordingInfo& info);
  /// Calls `take(statement)` for each row; it may return a Status.
  template <class Take>
  Status each(std::string_view sql, Take&& take);
  /// The same of the rows of a table that are as they were written; those that are not, or are missing, are noted.
  template <class Take>
  Status each_row(std::string_view table, std::string_view tail, Take&& take);

  SqlDatabase database_;
  std::int64_t version_ = 0;
  bool log_missing_ = false, ended_ = false, salvaged_ = false;
  std::optional<Block> before_;                             // read last with its points
  std::map<std::string, std::int64_t, std::less<>> tally_;  // rows of each table that were there at least
  std::vector<Finding> damage_;
  std::set<std::pair<std::string, std::string>> damaged_rows_;
  ColumnCells cells_;  // room for one column
  WatchLists watched_;
};

template <class Take>
Status RecordingReader::each(std::string_view sql, Take&& take) {
  auto statement = database_.prepare(sql);
  if (!statement) return read_error(database_, statement.error());
  Status taken;
  const auto status = statement->each([&] {
    if constexpr (std::is_void_v<decltype(take(*statement))>) {
      take(*statement);
    } else {
      taken = take(*statement);
    }
    return taken.has_value();
  });
  if (!status) return read_error(database_, status.error());
  return taken;
}

template <class Take>
Status RecordingReader::each_row(std::string_view table, std::string_view tail, Take&& take) {
  const int check = column_count(table);
  std::int64_t rows = 0;
  auto status = each(select_rows(table, version_, tail), [&](const SqlStatement& row) -> Status {
    ++rows;
    if (row.integer(check) == 0) {
      note_row(table, row);
      return {};
    }
    if constexpr (std::is_void_v<decltype(take(row))>) {
      take(row);
      return {};
    } else {
      return take(row);
    }
  });
  if (status) note_missing(table, rows);
  return status;
}

}  // namespace syncline
