// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "channels/cycle_sample.h"
#include "record/column_codec.h"
#include "record/recording.h"
#include "record/recording_schema.h"

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

/// Reads a recording, also one that is being written. What is damaged is told, not guessed. For one thread.
class RecordingReader {
 public:
  /// As open_recording(), and kFileNotReadable.
  [[nodiscard]] static Result<RecordingReader> open(const std::string& path);

  [[nodiscard]] const std::string& path() const { return database_.path(); }
  [[nodiscard]] Result<RecordingInfo> info();
  /// All samples in their order, a block at a time, until `take` returns false.
  [[nodiscard]] Status samples(const std::function<bool(std::span<const CycleSample>)>& take);
  /// A stretch of cycles as it was written, about a second.
  struct Block {
    std::int64_t number = 0, first_cycle = 0, last_cycle = 0, cycles = 0;
    Nanoseconds begin = 0, end = 0;  // host clock, of its first and its last cycle
    std::int64_t columns = 0;
  };
  /// All of them, in the order in which they were written.
  [[nodiscard]] Result<std::vector<Block>> blocks();
  /// The samples of one.
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
  using AllPoints = std::map<std::int64_t, Points>;  // by series_number()
  /// The samples of one block, and what it has of points() of counts and states behind what is there.
  [[nodiscard]] Status samples(const Block& block, std::vector<CycleSample>& out, AllPoints& points) {
    return read_block(block, out, &points);
  }
  /// As samples(), and in the same pass points() of all counts and states, whatever the number of slaves.
  [[nodiscard]] Status samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints& points);
  /// Reads everything: the database's own check, all samples, each sum against its samples. The first thing that is
  /// wrong; the number of blocks that were read.
  [[nodiscard]] Result<std::uint64_t> verify();

 private:
  explicit RecordingReader(SqlDatabase database) : database_(std::move(database)) {}
  /// In the order in which they were written.
  Status blocks(const std::function<Status(const Block&)>& take);
  /// `points`: null where they are not wanted.
  Status read_block(const Block& block, std::vector<CycleSample>& out, AllPoints* points = nullptr);
  Status read_samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints* points);
  /// A row "id, codec, count, cells, times" of a series that is no column.
  static bool read_points(const SqlStatement& row, Points& out);
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
  Status read_about(RecordingInfo& info);
  Status read_told(RecordingInfo& info);
  /// Calls `take(statement)` for each row; it may return a Status.
  template <class Take>
  Status each(std::string_view sql, Take&& take);

  SqlDatabase database_;
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

}  // namespace syncline
