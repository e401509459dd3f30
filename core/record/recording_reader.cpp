// SPDX-License-Identifier: Apache-2.0
#include "record/recording_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
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
  auto database = open_recording(path);
  if (!database) return tl::unexpected(database.error());
  return RecordingReader(std::move(*database));
}

Status RecordingReader::read_about(RecordingInfo& info) {
  auto& about = info.about;
  auto status = each("SELECT key, value FROM meta", [&](const SqlStatement& row) {
    const auto key = row.text(0);
    if (key == "program") about.program = row.text(1);
    if (key == "link") about.link = row.text(1);
    if (key == "armed") about.armed = number_of(row.text(1), RecordingAbout::kNotArmed);
    if (key == "ended") info.ended = row.text(1);
    if (key == "speed_counter_start") about.speed_counter_start = number_of<std::uint16_t>(row.text(1), 0x1000);
  });
  if (!status) return status;
  status = each("SELECT key, value FROM limits", [&](const SqlStatement& row) {
    const auto value = row.integer(1);
    if (row.text(0) == "cycle_time") about.limits.cycle_time = value;
    if (row.text(0) == "deviation") about.limits.deviation_ns = static_cast<std::uint32_t>(value);
    if (row.text(0) == "dcm_error") about.limits.dcm_error_ns = value;
  });
  if (!status) return status;
  status = each("SELECT kind, name, body FROM document ORDER BY kind", [&](const SqlStatement& row) {
    about.documents.push_back({std::string(row.text(0)), std::string(row.text(1)), std::string(row.blob(2))});
  });
  if (!status) return status;
  status = each("SELECT position, name, vendor_id, product_code, revision_no FROM slave ORDER BY position",
                [&](const SqlStatement& row) -> Status {
                  if (row.integer(0) != static_cast<std::int64_t>(about.slaves.size()) || row.integer(0) > kMostSlaves)
                    return damaged_recording(database_, because("its slaves are not numbered in a row"));
                  about.slaves.push_back({std::string(row.text(1)), static_cast<std::uint32_t>(row.integer(2)),
                                          static_cast<std::uint32_t>(row.integer(3)),
                                          static_cast<std::uint32_t>(row.integer(4))});
                  return {};
                });
  if (status && about.limits.cycle_time <= 0) return damaged_recording(database_, because("it has no cycle time"));
  if (status) status = read_watched(about.watched);
  return status;
}

Status RecordingReader::read_watched(WatchLists& watched) {
  watched = {};
  const auto version = recording_version(database_);
  if (!version) return read_error(database_, version.error());
  if (*version < kFirstWithVariables) return {};
  const auto no_lists = [this] {
    return damaged_recording(database_, because("its lists of watched variables are none"));
  };
  std::vector<WatchedVariable> variables;
  auto status =
      each("SELECT id, name, slave, direction, data_type, bit_offset, bit_size FROM variable ORDER BY id",
           [&](const SqlStatement& row) -> Status {
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
    status = each("SELECT number, place, variable FROM watch_list ORDER BY number, place",
                  [&](const SqlStatement& row) -> Status {
                    const auto number = row.integer(0);
                    const auto variable = row.integer(2);
                    if (number < 1 || number > kMostLists || variable < 0 ||
                        variable >= static_cast<std::int64_t>(variables.size()))
                      return no_lists();
                    // Of those that were empty there is no row.
                    if (static_cast<std::size_t>(number) > lists.size()) lists.resize(static_cast<std::size_t>(number));
                    if (row.integer(1) != static_cast<std::int64_t>(lists.back().size())) return no_lists();
                    lists.back().push_back(variables[static_cast<std::size_t>(variable)]);
                    return {};
                  });
  }
  if (!status) return status;
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
  const auto version = recording_version(database_);
  if (!version) return read_error(database_, version.error());
  const bool detailed = *version >= kFirstWithDetails;
  auto status = each(detailed ? "SELECT time_ns, slave, kind, text, details FROM event ORDER BY id"
                              : "SELECT time_ns, slave, kind, text, NULL FROM event ORDER BY id",
                     [&](const SqlStatement& row) {
                       info.events.push_back({row.integer(0), slave_of(row, 1), std::string(row.text(2)),
                                              std::string(row.text(3)), std::string(row.blob(4))});
                     });
  if (!status) return status;
  status = each(detailed ? "SELECT code, level, slave, text, details FROM finding ORDER BY id"
                         : "SELECT code, level, slave, text, NULL FROM finding ORDER BY id",
                [&](const SqlStatement& row) {
                  info.findings.push_back({std::string(row.text(0)), std::string(row.text(1)), slave_of(row, 2),
                                           std::string(row.text(3)), std::string(row.blob(4))});
                });
  if (!status) return status;
  return each("SELECT time_ns, text FROM note ORDER BY id", [&](const SqlStatement& row) {
    info.notes.push_back({row.integer(0), std::string(row.text(1))});
  });
}

Result<RecordingInfo> RecordingReader::info() {
  RecordingInfo info;
  auto status = read_about(info);
  if (status) status = read_told(info);
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
  return info;
}

Status RecordingReader::blocks(const std::function<Status(const Block&)>& take) {
  std::int64_t number = 0, next_cycle = 0;
  return each("SELECT number, first_cycle, last_cycle, cycles, begin_ns, end_ns, columns FROM block ORDER BY number",
              [&](const SqlStatement& row) -> Status {
                const Block block{row.integer(0), row.integer(1), row.integer(2), row.integer(3),
                                  row.integer(4), row.integer(5), row.integer(6)};
                const bool cycles = block.first_cycle >= next_cycle && block.last_cycle >= block.first_cycle &&
                                    block.last_cycle < INT64_MAX && block.cycles >= 1 &&
                                    block.cycles <= kMostBlockCycles &&
                                    block.cycles - 1 <= block.last_cycle - block.first_cycle;
                if (block.number != number || !cycles || block.end < block.begin)
                  return damaged_recording(database_, because("block {number} is none", block.number));
                ++number;
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
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(row.integer(2), 0));
  std::vector<Nanoseconds> times;
  std::vector<float> values;
  if (!decode_floats(row.blob(3), count, values) || !decode_times(row.blob(4), count, times)) return false;
  out.times.insert(out.times.end(), times.begin(), times.end());
  out.values.insert(out.values.end(), values.begin(), values.end());
  return true;
}

Status RecordingReader::read_block(const Block& block, std::vector<CycleSample>& out, AllPoints* points) {
  const auto count = static_cast<std::size_t>(block.cycles);
  out.assign(count, CycleSample{});
  // One that is being written may have others by now.
  if (auto status = read_watched(watched_); !status) return status;
  const bool whole = points != nullptr || !watched_.variables().empty();
  auto row = database_.prepare("SELECT id, codec, count, cells, times FROM data WHERE id >= ? AND id < ? ORDER BY id");
  if (!row) return read_error(database_, row.error());
  const auto first = block.number * kSeriesPerBlock;
  row->bind(0, first).bind(1, first + (whole ? kSeriesPerBlock : kBusSeries));
  std::int64_t columns = 0;
  std::optional<std::int64_t> bad;
  std::array<bool, kSignalCount> there{};
  const auto status = row->each([&] {
    const auto series = row->integer(0) - first;
    const auto codec = row->integer(1);
    bool good = true;
    if (const auto put = column_writer(series)) {
      ++columns;
      there[static_cast<std::size_t>(series)] = true;
      good = row->integer(2) == block.cycles &&
             decode_column(static_cast<ColumnCodec>(codec), row->blob(3), count, cells_);
      if (good) put(out, cells_);
    } else if (const auto variable = variable_of(series)) {
      ++columns;  // behind the column that says of which list each cycle is
      good = row->integer(2) == block.cycles &&
             decode_column(static_cast<ColumnCodec>(codec), row->blob(3), count, cells_) &&
             take_watched_cells(watched_, *variable, cells_, out);
    } else if (points != nullptr && codec == 0 && is_held(series)) {
      good = read_points(*row, (*points)[series]);
    }
    if (!good) bad = series;
    return good;
  });
  if (!status) return read_error(database_, status.error());
  if (bad) return unread(block, *bad);
  for (const auto column : {Signal::kCycle, Signal::kSendTime, Signal::kFlags}) {
    if (!there[static_cast<std::size_t>(column)]) return unread(block, series_number(column));
  }
  const auto is = [](std::uint64_t cycle, std::int64_t said) { return static_cast<std::int64_t>(cycle) == said; };
  if (columns != block.columns || !is(out.front().cycle, block.first_cycle) ||
      !is(out.back().cycle, block.last_cycle) || out.front().send_time != block.begin ||
      out.back().send_time != block.end) {
    return damaged_recording(database_, because("block {number} holds other cycles than it says", block.number));
  }
  return {};
}

Status RecordingReader::read_samples(const std::function<bool(std::span<const CycleSample>)>& take, AllPoints* points) {
  std::vector<CycleSample> samples;
  bool more = true;
  return blocks([&](const Block& block) -> Status {
    if (!more) return {};
    if (auto status = read_block(block, samples, points); !status) return status;
    more = take(samples);
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
  auto row = database_.prepare("SELECT count, min, max, last FROM summary WHERE id = ?");
  if (!row) return read_error(database_, row.error());
  auto status = blocks([&](const Block& block) -> Status {
    row->bind(0, block.number * kSeriesPerBlock + series_number(signal, slave));
    const auto there = row->step();
    if (!there) return read_error(database_, there.error());
    if (*there) {
      result.push_back({block.begin, block.end, row->integer(0), row->real(1), row->real(2), row->real(3)});
    }
    row->reset();
    return {};
  });
  if (!status) return tl::unexpected(status.error());
  return result;
}

Result<RecordingReader::Points> RecordingReader::points(Signal signal, int slave) {
  Points result;
  auto row = database_.prepare("SELECT codec, count, times, cells FROM data WHERE id = ?");
  if (!row) return read_error(database_, row.error());
  std::vector<Nanoseconds> times;
  std::vector<float> values;
  auto status = blocks([&](const Block& block) -> Status {
    row->bind(0, block.number * kSeriesPerBlock + series_number(signal, slave));
    const auto there = row->step();
    if (!there) return read_error(database_, there.error());
    if (!*there) {
      row->reset();
      return {};
    }
    const auto count = static_cast<std::size_t>(std::max<std::int64_t>(row->integer(1), 0));
    const bool good =
        row->integer(0) == 0 && decode_times(row->blob(2), count, times) && decode_floats(row->blob(3), count, values);
    row->reset();
    if (!good) {
      return damaged_recording(
          database_, because("{signal} of block {number} cannot be read", syncline::info(signal).key, block.number));
    }
    result.times.insert(result.times.end(), times.begin(), times.end());
    result.values.insert(result.values.end(), values.begin(), values.end());
    return {};
  });
  if (!status) return tl::unexpected(status.error());
  return result;
}

}  // namespace syncline
