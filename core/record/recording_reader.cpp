// SPDX-License-Identifier: Apache-2.0
#include "record/recording_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

#include "reasons/because.h"
#include "record/column_codec.h"
#include "record/sample_columns.h"
#include "record/watched_columns.h"

namespace syncline {
namespace {

/// More slaves than a segment can have: the number is damaged.
constexpr std::int64_t kMostSlaves = 65'535;
/// More than anybody chooses in a run: the number is damaged.
constexpr std::int64_t kMostLists = 1 << 20;

/// What samples do not tell. Earlier files also have the readings of slaves so, which stand in their cycles.
bool is_held(std::int64_t series) {
  const auto signal = static_cast<std::size_t>(series % kBusSeries);
  return signal < kSignalCount && signals()[signal].form == SignalInfo::Form::kHeld;
}

template <class T>
T number_of(std::string_view text, T otherwise) {
  T value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

Result<RecordingReader> RecordingReader::open(const std::string& path) {
  const bool log_missing = lacks_log(path);  // before SQLite makes an empty one
  auto database = open_recording(path);
  if (!database && database.error().code == ErrorCode::kFileNotReadable) {
    if (auto salvaged = salvage_recording(path)) {
      if (salvaged->cycles == 0) return no_cycle_left(path);
      RecordingReader reader(std::move(salvaged->database), kRecordingVersion, log_missing);
      reader.note_cut(*salvaged);
      return reader;
    }
  }
  if (!database) return tl::unexpected(database.error());
  const auto version = recording_version(*database);
  if (!version) return read_error(*database, version.error());
  return RecordingReader(std::move(*database), *version, log_missing);
}

Status RecordingReader::read_about(RecordingInfo& info) {
  auto& about = info.about;
  auto status = read_tally();
  if (!status) return status;
  status = each_row("meta", "", [&](const SqlStatement& row) {
    const auto key = row.text(0);
    if (key == "program") about.program = row.text(1);
    if (key == "link") about.link = row.text(1);
    if (key == "armed") about.armed = number_of(row.text(1), RecordingAbout::kNotArmed);
    if (key == "ended") info.ended = row.text(1);
    if (key == "ended") ended_ = true;
    if (key == "speed_counter_start") about.speed_counter_start = number_of<std::uint16_t>(row.text(1), 0x1000);
  });
  if (!status) return status;
  status = each_row("limits", "", [&](const SqlStatement& row) {
    const auto value = row.integer(1);
    if (row.text(0) == "cycle_time") about.limits.cycle_time = value;
    if (row.text(0) == "deviation") about.limits.deviation_ns = static_cast<std::uint32_t>(value);
    if (row.text(0) == "dcm_error") about.limits.dcm_error_ns = value;
  });
  if (!status) return status;
  status = each_row("document", "ORDER BY kind", [&](const SqlStatement& row) {
    about.documents.push_back({std::string(row.text(0)), std::string(row.text(1)), std::string(row.blob(2))});
  });
  if (!status) return status;
  // A slave whose row is damaged keeps its place, and has no name.
  const auto fill_up = [&](std::int64_t position) {
    while (is_checked() && static_cast<std::int64_t>(about.slaves.size()) < std::min(position, kMostSlaves))
      about.slaves.push_back({"?"});
  };
  status = each_row("slave", "ORDER BY position", [&](const SqlStatement& row) -> Status {
    fill_up(row.integer(0));
    if (row.integer(0) != static_cast<std::int64_t>(about.slaves.size()) || row.integer(0) > kMostSlaves)
      return damaged_recording(database_, because("its slaves are not numbered in a row"));
    about.slaves.push_back({std::string(row.text(1)), static_cast<std::uint32_t>(row.integer(2)),
                            static_cast<std::uint32_t>(row.integer(3)), static_cast<std::uint32_t>(row.integer(4))});
    return {};
  });
  if (status) fill_up(tally_["slave"]);
  if (status && about.limits.cycle_time <= 0 && !damage_.empty()) return damaged_row();
  if (status && about.limits.cycle_time <= 0) return damaged_recording(database_, because("it has no cycle time"));
  if (status) status = read_watched(about.watched);
  return status;
}

Status RecordingReader::read_watched(WatchLists& watched) {
  watched = {};
  if (version_ < kFirstWithVariables) return {};
  const auto no_lists = [this]() -> Status {
    if (!damage_.empty()) return damaged_row();
    return damaged_recording(database_, because("its lists of watched variables are none"));
  };
  const auto damage = damage_.size();
  std::vector<WatchedVariable> variables;
  auto status = each_row("variable", "ORDER BY id", [&](const SqlStatement& row) -> Status {
    const auto size = row.integer(6);
    if (row.integer(0) != static_cast<std::int64_t>(variables.size()) || size < 1 ||
        size > static_cast<std::int64_t>(kMostWatchedBits))
      return no_lists();
    variables.push_back({std::string(row.text(1)), std::string(row.text(4)), row.text(3) == "output",
                         static_cast<std::uint32_t>(row.integer(5)), static_cast<std::uint32_t>(size),
                         row.is_null(2) ? -1 : static_cast<int>(row.integer(2))});
    return {};
  });
  std::vector<std::vector<WatchedVariable>> lists;
  if (status) {
    status = each_row("watch_list", "ORDER BY number, place", [&](const SqlStatement& row) -> Status {
      const auto number = row.integer(0);
      const auto variable = row.integer(2);
      if (number < 1 || number > kMostLists || variable < 0 || variable >= static_cast<std::int64_t>(variables.size()))
        return no_lists();
      // Of those that were empty there is no row.
      if (static_cast<std::size_t>(number) > lists.size()) lists.resize(static_cast<std::size_t>(number));
      if (row.integer(1) != static_cast<std::int64_t>(lists.back().size())) return no_lists();
      lists.back().push_back(variables[static_cast<std::size_t>(variable)]);
      return {};
    });
  }
  if (!status) return status;
  // Without one of them nobody knows which variable a cell is of.
  if (damage_.size() > damage) return damaged_row();
  for (const auto& list : lists) {
    if (!watched.add(list)) return no_lists();
  }
  return watched.variables() == variables ? Status{} : no_lists();
}

std::optional<std::size_t> RecordingReader::variable_of(std::int64_t series) const {
  const auto number = series - static_cast<std::int64_t>(Signal::kVariable);
  if (number < kBusSeries || number % kBusSeries != 0) return std::nullopt;
  const auto variable = static_cast<std::size_t>(number / kBusSeries - 1);
  return variable < watched_.variables().size() ? std::optional(variable) : std::nullopt;
}

Status RecordingReader::read_told(RecordingInfo& info) {
  const auto slave_of = [](const SqlStatement& row, int column) {
    return row.is_null(column) ? -1 : static_cast<int>(row.integer(column));
  };
  auto status = each_row("event", "ORDER BY id", [&](const SqlStatement& row) {
    info.events.push_back({row.integer(1), slave_of(row, 2), std::string(row.text(3)), std::string(row.text(4)),
                           std::string(row.blob(5))});
  });
  if (!status) return status;
  status = each_row("finding", "ORDER BY id", [&](const SqlStatement& row) {
    info.findings.push_back({std::string(row.text(1)), std::string(row.text(2)), slave_of(row, 3),
                             std::string(row.text(4)), std::string(row.blob(5))});
  });
  if (!status) return status;
  return each_row("note", "ORDER BY id", [&](const SqlStatement& row) {
    info.notes.push_back({row.integer(1), std::string(row.text(2))});
  });
}

Result<RecordingInfo> RecordingReader::info() {
  auto info = read_info();
  if (info || info.error().code != ErrorCode::kFileNotReadable) return info;
  if (auto status = salvage(std::move(info.error())); !status) return tl::unexpected(std::move(status.error()));
  return read_info();
}

Result<RecordingInfo> RecordingReader::read_info() {
  RecordingInfo info;
  Status status;
  {
    // Rows are counted against what is told of them: both of one state of the file.
    const auto held = hold();
    if (!held) return tl::unexpected(held.error());
    status = read_about(info);
    if (status) status = read_told(info);
  }
  std::int64_t first = 0, last = 0;
  if (status) {
    status = blocks([&](const Block& block) -> Status {
      if (info.blocks == 0) {
        info.begin = block.begin;
        first = block.first_cycle;
      }
      last = block.last_cycle;
      ++info.blocks;
      info.cycles += static_cast<std::uint64_t>(block.cycles);
      info.end = block.end;
      return {};
    });
  }
  if (!status) return tl::unexpected(status.error());
  if (info.blocks > 0) info.missing_cycles = static_cast<std::uint64_t>(last - first + 1) - info.cycles;
  for (auto& told : recorded(found())) info.findings.push_back(std::move(told));
  return info;
}

Status RecordingReader::blocks(const std::function<Status(const Block&)>& take) {
  std::int64_t number = 0, next_cycle = 0;
  return each_row("block", "ORDER BY number", [&](const SqlStatement& row) -> Status {
    const Block block{row.integer(0), row.integer(1), row.integer(2), row.integer(3), row.integer(4),
                      row.integer(5), row.integer(6), row.integer(7), row.integer(8)};
    const bool cycles = block.first_cycle >= next_cycle && block.last_cycle >= block.first_cycle &&
                        block.last_cycle < INT64_MAX && block.cycles >= 1 && block.cycles <= kMostBlockCycles &&
                        block.cycles - 1 <= block.last_cycle - block.first_cycle;
    // Where rows have checks, those before it that are missing have been noted, or will be.
    const bool in_place = block.number == number || (is_checked() && block.number > number);
    if (!in_place || !cycles || block.end < block.begin)
      return damaged_recording(database_, because("block {number} is none", block.number));
    number = block.number + 1;
    next_cycle = block.last_cycle + 1;
    return take(block);
  });
}

Result<std::vector<RecordingReader::Block>> RecordingReader::blocks() {
  std::vector<Block> all;
  const auto status = blocks([&all](const Block& block) -> Status {
    all.push_back(block);
    return {};
  });
  if (!status) return tl::unexpected(status.error());
  return all;
}

bool RecordingReader::read_points(const SqlStatement& row, Points& out) {
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(row.integer(kDataCount), 0));
  std::vector<Nanoseconds> times;
  std::vector<float> values;
  if (row.integer(kDataCodec) != 0 || !decode_floats(row.blob(kDataCells), count, values) ||
      !decode_times(row.blob(kDataTimes), count, times))
    return false;
  out.times.insert(out.times.end(), times.begin(), times.end());
  out.values.insert(out.values.end(), values.begin(), values.end());
  return true;
}

void RecordingReader::forget(Points& points, Nanoseconds from) {
  points.times.push_back(points.times.empty() ? from : std::max(from, points.times.back()));
  points.values.push_back(std::numeric_limits<float>::quiet_NaN());
}

void RecordingReader::forget_all(AllPoints& points, Nanoseconds from) {
  for (auto& series : points) forget(series.second, from);
}

Status RecordingReader::read_block(const Block& block, std::vector<CycleSample>& out, AllPoints* points) {
  // One that is being written may have others by now.
  if (auto status = read_watched(watched_); !status) return status;
  // What changed in blocks that are not there is not known.
  if (points != nullptr && before_ && block.number > before_->number + 1) forget_all(*points, before_->end + 1);
  if (points != nullptr) before_ = block;
  const auto whole = read_rows(block, out, points);
  if (!whole) return tl::unexpected(whole.error());
  if (!*whole) out.clear();
  return {};
}

Result<bool> RecordingReader::read_rows(const Block& block, std::vector<CycleSample>& out, AllPoints* points) {
  const auto count = static_cast<std::size_t>(block.cycles);
  out.assign(count, CycleSample{});
  const bool all = points != nullptr || !watched_.variables().empty();
  auto row = database_.prepare(select_rows("data", version_, "WHERE id >= ? AND id < ? ORDER BY id"));
  if (!row) return read_error(database_, row.error());
  const auto first = block.number * kSeriesPerBlock;
  row->bind(0, first).bind(1, first + (all ? kSeriesPerBlock : kBusSeries));
  std::int64_t columns = 0, held = 0;
  bool whole = true;
  std::array<bool, kSignalCount> there{};
  const auto status = row->each([&] {
    const auto series = row->integer(kDataId) - first;
    const bool as_written = row->integer(kDataCheck) != 0;
    const auto cells = [&] {
      ++columns;
      return as_written && row->integer(kDataCount) == block.cycles &&
             decode_column(static_cast<ColumnCodec>(row->integer(kDataCodec)), row->blob(kDataCells), count, cells_);
    };
    if (const auto put = column_writer(series)) {
      there[static_cast<std::size_t>(series)] = true;
      if (cells()) return put(out, cells_);
      note_gap("data", row->text(kDataId), block);
      whole = false;
    } else if (const auto variable = variable_of(series)) {
      // Behind the column that says of which list each cycle is.
      if (cells() && take_watched_cells(watched_, *variable, cells_, out)) return;
      note_series(row->text(kDataId), series, block);
    } else {
      ++held;
      if (points == nullptr || (as_written && !is_held(series))) return;
      if (as_written && read_points(*row, (*points)[series])) return;
      note_series(row->text(kDataId), series, block);
      forget((*points)[series], block.begin);
    }
  });
  if (!status && !is_damaged(status.error())) return read_error(database_, status.error());
  const auto missing_columns = block.columns - columns;
  const auto missing_held = all && block.held >= 0 ? block.held - held : 0;
  // Which of them changed in it is not known.
  if (points != nullptr && (!status || missing_held != 0)) forget_all(*points, block.begin);
  const auto is = [](std::uint64_t cycle, std::int64_t said) { return static_cast<std::int64_t>(cycle) == said; };
  constexpr std::array kNeeded{Signal::kCycle, Signal::kSendTime, Signal::kFlags};
  const bool as_said =
      status && missing_columns == 0 && missing_held == 0 &&
      std::ranges::all_of(kNeeded, [&there](Signal column) { return there[static_cast<std::size_t>(column)]; }) &&
      is(out.front().cycle, block.first_cycle) && is(out.back().cycle, block.last_cycle) &&
      out.front().send_time == block.begin && out.back().send_time == block.end;
  if (whole && !as_said) {
    note_block(block, std::max<std::int64_t>(missing_columns, 0) + std::max<std::int64_t>(missing_held, 0));
  }
  return whole && as_said;
}

Status RecordingReader::read_samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints* points) {
  std::vector<CycleSample> samples;
  bool more = true;
  return blocks([&](const Block& block) -> Status {
    if (!more) return {};
    if (auto status = read_block(block, samples, points); !status) return status;
    if (!samples.empty()) more = take(samples);
    return {};
  });
}

Status RecordingReader::samples(const std::function<bool(std::span<const CycleSample>)>& take) {
  return read_samples(take, nullptr);
}

Status RecordingReader::samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints& points) {
  return read_samples(take, &points);
}

Result<std::vector<BlockSummary>> RecordingReader::overview(Signal signal, int slave) {
  std::vector<BlockSummary> result;
  auto row = database_.prepare(select_rows("summary", version_, "WHERE id = ?"));
  if (!row) return read_error(database_, row.error());
  auto status = blocks([&](const Block& block) -> Status {
    row->bind(0, block.number * kSeriesPerBlock + series_number(signal, slave));
    const auto there = row->step();
    if (!there) return read_error(database_, there.error());
    if (*there && row->integer(kSummaryCheck) == 0) {
      note_row("summary", *row);
    } else if (*there) {
      result.push_back({block.begin, block.end, row->integer(kSummaryCount), row->real(kSummaryMin),
                        row->real(kSummaryMax), row->real(kSummaryLast)});
    }
    row->reset();
    return {};
  });
  if (!status) return tl::unexpected(status.error());
  return result;
}

Result<RecordingReader::Points> RecordingReader::points(Signal signal, int slave) {
  Points result;
  auto row = database_.prepare(select_rows("data", version_, "WHERE id = ?"));
  if (!row) return read_error(database_, row.error());
  const auto series = series_number(signal, slave);
  auto status = blocks([&](const Block& block) -> Status {
    row->bind(0, block.number * kSeriesPerBlock + series);
    const auto there = row->step();
    if (!there) return read_error(database_, there.error());
    if (*there && (row->integer(kDataCheck) == 0 || !read_points(*row, result))) {
      note_series(row->text(kDataId), series, block);
      forget(result, block.begin);
    }
    row->reset();
    return {};
  });
  if (!status) return tl::unexpected(status.error());
  return result;
}

}  // namespace syncline
