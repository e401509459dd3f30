// SPDX-License-Identifier: Apache-2.0
#include "record/recording_writer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "record/column_codec.h"
#include "record/recording_rows.h"
#include "record/recording_schema.h"
#include "record/sample_columns.h"
#include "record/watched_columns.h"
#include "sqlite/database_files.h"

namespace syncline {
namespace {

using Form = SignalInfo::Form;
using Scope = SignalInfo::Scope;

SampleStore::Layout layout_of(const RecordingAbout& about) {
  // Only what the next block needs is looked up in it.
  return {.slaves = about.slaves.size(),
          .cycle_time = about.limits.cycle_time,
          .cycle_capacity = static_cast<std::size_t>(kMostBlockCycles),
          .speed_counter_start = about.speed_counter_start,
          .sync0 = about.sync0};
}

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

std::string levels_of(std::span<const float> values) {
  std::vector<float> levels;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % kLevelCycles == 0) levels.insert(levels.end(), {kNothing, kNothing});
    if (std::isnan(values[i])) continue;
    auto& low = levels[levels.size() - 2];
    auto& high = levels.back();
    if (!(low <= values[i])) low = values[i];
    if (!(high >= values[i])) high = values[i];
  }
  return encode_floats(levels);
}

void drawn_values(std::span<const CycleSample> samples, const SignalInfo& signal, std::vector<float>& values) {
  values.clear();
  for (const auto& sample : samples) {
    const auto number = signal.of_cycle(sample);
    values.push_back(number ? static_cast<float>(as_double(*number)) : kNothing);
  }
}

}  // namespace

RecordingWriter::RecordingWriter(SqlDatabase database, const RecordingAbout& about)
    : database_(std::move(database)), store_(layout_of(about)), lists_(about.watched) {}

Result<RecordingWriter> RecordingWriter::create(const std::string& path, const RecordingAbout& about) {
  auto database = create_recording(path);
  if (!database) return tl::unexpected(database.error());
  Error why;
  {
    RecordingWriter writer(std::move(*database), about);
    const auto status = writer.begin(about);
    if (status) return writer;
    why = write_error(writer.database_, status.error()).value();
  }
  remove_database(path);  // closed by now
  return tl::unexpected(std::move(why));
}

Status RecordingWriter::write(const RecordingBatch& batch) {
  auto transaction = SqlTransaction::begin(database_);
  if (!transaction) return write_error(database_, transaction.error());
  const auto before = tally_;
  auto status = add_lists(batch.lists);
  store(batch);
  for (auto rest = std::span(batch.samples); status && !rest.empty();) {
    const auto count = std::min(rest.size(), static_cast<std::size_t>(kMostBlockCycles));
    // What snapshots tell stands in the last one; what those without samples tell waits for the next.
    const bool last = count == rest.size();
    status = put_block(rest.first(count), last ? std::optional(batch.samples.front().send_time) : std::nullopt);
    rest = rest.subspan(count);
  }
  if (status) status = put_told(batch);
  if (status) status = tally_.write(database_);
  if (status) status = transaction->commit();
  if (status) return {};
  tally_ = before;
  return write_error(database_, status.error());
}

/// In the order in which they were taken.
void RecordingWriter::store(const RecordingBatch& batch) {
  std::size_t done = 0;
  for (const auto& taken : batch.snapshots) {
    const auto until = std::clamp(taken.after, done, batch.samples.size());
    store_.append(std::span(batch.samples).subspan(done, until - done));
    done = until;
    store_.append(taken.snapshot);
  }
  store_.append(std::span(batch.samples).subspan(done));
}

Status RecordingWriter::put_block(std::span<const CycleSample> samples, std::optional<Nanoseconds> held_from) {
  sums_ = 0;
  const auto columns = put_columns(samples);
  if (!columns) return tl::unexpected(columns.error());
  const auto variables = put_variables(samples);
  if (!variables) return tl::unexpected(variables.error());
  if (auto status = put_sums(samples); !status) return status;
  if (!any_) first_ = samples.front().send_time;
  any_ = true;
  last_ = samples.back().send_time;
  const auto held = held_from ? put_held(blocks_, *held_from) : Result<std::int64_t>(0);
  if (!held) return tl::unexpected(held.error());
  // Behind its rows: it says how many they are.
  auto row = database_.prepare(insert_row("block"));
  if (!row) return tl::unexpected(row.error());
  row->bind(0, blocks_).bind(1, static_cast<std::int64_t>(samples.front().cycle));
  row->bind(2, static_cast<std::int64_t>(samples.back().cycle)).bind(3, static_cast<std::int64_t>(samples.size()));
  row->bind(4, samples.front().send_time).bind(5, samples.back().send_time).bind(6, *columns + *variables);
  row->bind(7, *held).bind(8, sums_);
  ++blocks_;
  tally_.add("block");
  return row->run();
}

Result<std::int64_t> RecordingWriter::put_columns(std::span<const CycleSample> samples) {
  auto row = database_.prepare(insert_row("data"));
  if (!row) return tl::unexpected(row.error());
  std::int64_t count = 0;
  Cells cells(samples.size());
  std::vector<float> values;
  for (const auto column : sample_columns()) {
    const auto& signal = info(column);
    std::ranges::transform(samples, cells.begin(), signal.of_cycle);
    const auto encoded = encode_column(cells);
    if (!encoded) continue;
    ++count;
    const auto series = series_number(column);
    if (auto status = put_series(series, column, -1); !status) return tl::unexpected(status.error());
    std::string levels;
    if (signal.form == Form::kCycles) {
      drawn_values(samples, signal, values);
      levels = levels_of(values);
    }
    row->bind(0, blocks_ * kSeriesPerBlock + series).bind(1, static_cast<std::int64_t>(encoded->codec));
    row->bind(2, static_cast<std::int64_t>(samples.size())).bind_null(3).bind_blob(4, encoded->bytes);
    if (auto status = (levels.empty() ? row->bind_null(5) : row->bind_blob(5, levels)).run(); !status)
      return tl::unexpected(status.error());
    if (signal.form != Form::kCycles) continue;
    if (auto status = put_summary(blocks_, series, values); !status) return tl::unexpected(status.error());
  }
  return count;
}

/// As put_columns().
Result<std::int64_t> RecordingWriter::put_variables(std::span<const CycleSample> samples) {
  auto row = database_.prepare(insert_row("data"));
  if (!row) return tl::unexpected(row.error());
  std::int64_t count = 0;
  Cells cells;
  std::vector<float> values;
  for (std::size_t variable = 0; variable < lists_.variables().size(); ++variable) {
    put_watched_cells(lists_, variable, samples, cells);
    const auto encoded = encode_column(cells);
    if (!encoded) continue;
    ++count;
    const auto number = static_cast<int>(variable);
    const auto series = series_number(Signal::kVariable, number);
    if (auto status = put_series(series, Signal::kVariable, lists_.variables()[variable].slave); !status)
      return tl::unexpected(status.error());
    values.clear();
    for (const auto& sample : samples) values.push_back(lists_.drawn(sample, variable));
    row->bind(0, blocks_ * kSeriesPerBlock + series).bind(1, static_cast<std::int64_t>(encoded->codec));
    row->bind(2, static_cast<std::int64_t>(samples.size())).bind_null(3).bind_blob(4, encoded->bytes);
    const auto levels = levels_of(values);
    if (auto status = row->bind_blob(5, levels).run(); !status) return tl::unexpected(status.error());
    if (auto status = put_summary(blocks_, series, values); !status) return tl::unexpected(status.error());
  }
  return count;
}

/// Signals that are made of others: their pictures at least need no sums.
Status RecordingWriter::put_sums(std::span<const CycleSample> samples) {
  std::vector<float> values;
  for (const auto& signal : signals()) {
    const bool is_column = std::ranges::find(sample_columns(), signal.id) != sample_columns().end();
    if (signal.form != Form::kCycles || is_column) continue;
    drawn_values(samples, signal, values);
    if (auto status = put_summary(blocks_, series_number(signal.id), values); !status) return status;
  }
  return {};
}

Result<std::int64_t> RecordingWriter::put_held(std::int64_t block, Nanoseconds begin) {
  const auto& store = watched_ != nullptr ? *watched_ : store_;
  const auto until = watched_ != nullptr ? last_ + 1 : std::numeric_limits<Nanoseconds>::max();
  auto row = database_.prepare(insert_row("data"));
  if (!row) return tl::unexpected(row.error());
  std::int64_t rows = 0;
  std::vector<Nanoseconds> times;
  std::vector<float> values;
  for (const auto& signal : signals()) {
    const bool of_slaves = signal.scope == Scope::kSlave;
    // What single cycles tell, the reading of one slave in each among it, stands in the columns.
    if (signal.form != Form::kHeld || (!of_slaves && signal.of_bus == nullptr)) continue;
    for (std::size_t slave = 0; slave < (of_slaves ? store.slave_count() : 1); ++slave) {
      const auto number = series_number(signal.id, of_slaves ? static_cast<int>(slave) : -1);
      const auto& series = store.series(signal.id, slave);
      const auto seen = written_.try_emplace(number, std::numeric_limits<Nanoseconds>::min()).first;
      // Until something of it was written: what was looked at and had nothing for the file is none the less new to it.
      const bool fresh = seen->second == std::numeric_limits<Nanoseconds>::min();
      if (series.empty() || (!fresh && seen->second == series.last_time())) continue;
      times.clear();
      values.clear();
      auto from = seen->second + (fresh ? 0 : 1);
      if (fresh && watched_ != nullptr) {
        // What holds when the recording begins was read before.
        if (const auto holds = series.held_at(begin)) {
          times.push_back(holds->time);
          values.push_back(holds->value);
        }
        from = begin + 1;
      }
      series.for_each(from, until, [&](Nanoseconds time, float value) {
        times.push_back(time);
        values.push_back(value);
      });
      if (times.empty()) continue;
      seen->second = times.back();
      if (auto status = put_series(number, signal.id, of_slaves ? static_cast<int>(slave) : -1); !status)
        return tl::unexpected(status.error());
      if (auto status = put_summary(block, number, values); !status) return tl::unexpected(status.error());
      const auto time_bytes = encode_times(times);
      const auto value_bytes = encode_floats(values);
      row->bind(0, block * kSeriesPerBlock + number).bind(1, std::int64_t{0});
      row->bind(2, static_cast<std::int64_t>(times.size())).bind_blob(3, time_bytes).bind_blob(4, value_bytes);
      if (auto status = row->bind_null(5).run(); !status) return tl::unexpected(status.error());
      ++rows;
    }
  }
  return rows;
}

Status RecordingWriter::put_series(std::int64_t series, Signal signal, int slave) {
  if (!known_series_.insert(series).second) return {};
  auto row = database_.prepare(insert_row("series"));
  if (!row) return tl::unexpected(row.error());
  tally_.add("series");
  row->bind(0, series).bind(1, static_cast<std::int64_t>(signal));
  return (slave >= 0 ? row->bind(2, std::int64_t{slave}) : row->bind_null(2)).run();
}

Status RecordingWriter::put_summary(std::int64_t block, std::int64_t series, const std::vector<float>& values) {
  std::int64_t count = 0;
  double low = 0, high = 0, last = 0;
  for (const auto value : values) {
    if (std::isnan(value)) continue;
    const auto v = static_cast<double>(value);
    low = count == 0 ? v : std::min(low, v);
    high = count == 0 ? v : std::max(high, v);
    last = v;
    ++count;
  }
  if (count == 0) return {};
  auto row = database_.prepare(insert_row("summary"));
  if (!row) return tl::unexpected(row.error());
  ++sums_;
  row->bind(0, block * kSeriesPerBlock + series).bind(1, count);
  return row->bind_real(2, low).bind_real(3, high).bind_real(4, last).run();
}

Status RecordingWriter::finish(const std::string& why, std::span<const RecordedFinding> findings) {
  auto transaction = SqlTransaction::begin(database_);
  if (!transaction) return write_error(database_, transaction.error());
  auto status = put_findings(findings);
  if (status) status = put_meta("ended", why);
  if (status) status = tally_.write(database_);
  if (status) status = transaction->commit();
  // Without its log it is one file, which can be read where nothing can be written.
  if (status) status = database_.execute("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode=DELETE;");
  if (!status) return write_error(database_, status.error());
  return {};
}

std::uint64_t RecordingWriter::bytes() const { return database_bytes(path()); }

}  // namespace syncline
