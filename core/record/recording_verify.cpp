// SPDX-License-Identifier: Apache-2.0
// RecordingReader::verify(): everything is read and held against what is said of it.
#include "record/recording_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "reasons/because.h"
#include "record/sample_columns.h"
#include "record/watched_columns.h"

namespace syncline {

Status RecordingReader::check_sums(const Block& block, std::span<const CycleSample> samples) {
  std::vector<float> values(samples.size());
  for (const auto& signal : signals()) {
    if (signal.form != SignalInfo::Form::kCycles) continue;
    std::ranges::transform(samples, values.begin(), [&](const CycleSample& sample) {
      const auto number = signal.of_cycle(sample);
      return number ? static_cast<float>(as_double(*number)) : std::numeric_limits<float>::quiet_NaN();
    });
    const auto series = series_number(signal.id);
    if (auto status = check_sum(block, series, signal.key, values); !status) return status;
    if (std::ranges::find(sample_columns(), signal.id) == sample_columns().end()) continue;
    if (auto status = check_levels(block, series, signal.key, values); !status) return status;
  }
  for (std::size_t i = 0; i < watched_.variables().size(); ++i) {
    std::ranges::transform(samples, values.begin(),
                           [&](const CycleSample& sample) { return watched_.drawn(sample, i); });
    const auto series = series_number(Signal::kVariable, static_cast<int>(i));
    const auto& name = watched_.variables()[i].name;
    if (auto status = check_sum(block, series, name, values); !status) return status;
    if (auto status = check_levels(block, series, name, values); !status) return status;
  }
  return {};
}

Status RecordingReader::check_levels(const Block& block, std::int64_t series, std::string_view key,
                                     std::span<const float> values) {
  std::vector<Range> buckets((values.size() + kLevelCycles - 1) / kLevelCycles);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) buckets[i / kLevelCycles].take({values[i], values[i]});
  }
  if (std::ranges::all_of(buckets, &Range::empty)) return {};
  std::vector<Range> written;
  if (auto status = read_levels(block, series, written); !status) return status;
  if (written == buckets) return {};
  return damaged_recording(
      database_, because("the sums of {signal} in block {number} are not those of its values", key, block.number));
}

Status RecordingReader::check_sum(const Block& block, std::int64_t series, std::string_view key,
                                  std::span<const float> values) {
  auto row = database_.prepare(select_rows("summary", version_, "WHERE id = ?"));
  if (!row) return read_error(database_, row.error());
  std::int64_t count = 0;
  float low = 0, high = 0;
  for (const auto value : values) {
    if (std::isnan(value)) continue;
    low = count == 0 ? value : std::min(low, value);
    high = count == 0 ? value : std::max(high, value);
    ++count;
  }
  row->bind(0, block.number * kSeriesPerBlock + series);
  const auto there = row->step();
  if (!there) return read_error(database_, there.error());
  const bool same = *there
                        ? row->integer(kSummaryCount) == count && static_cast<float>(row->real(kSummaryMin)) == low &&
                              static_cast<float>(row->real(kSummaryMax)) == high
                        : count == 0;
  row->reset();  // else it would keep writers of notes waiting
  if (same) return {};
  return damaged_recording(
      database_, because("the sums of {signal} in block {number} are not those of its values", key, block.number));
}

Status RecordingReader::check_rows(const Block& block) {
  if (!is_checked()) return {};
  const auto first = block.number * kSeriesPerBlock;
  const auto check = [&](std::string_view table, const std::string& sql, int place, std::int64_t counted) -> Status {
    auto row = database_.prepare(sql);
    if (!row) return read_error(database_, row.error());
    row->bind(0, first).bind(1, first + kSeriesPerBlock);
    std::int64_t rows = 0;
    const auto status = row->each([&] {
      ++rows;
      if (row->integer(place) == 0) note_row(table, *row);
    });
    if (!status) return read_error(database_, status.error());
    if (rows == counted) return {};
    return damaged_recording(database_, because("block {number} holds other cycles than it says", block.number));
  };
  constexpr std::string_view kOfBlock = "WHERE id >= ? AND id < ?";
  const auto columns = block.columns + block.held;
  auto status = check("data", select_rows("data", version_, kOfBlock), kDataCheck, columns);
  if (status) status = check("data", select_levels(version_, kOfBlock), 2, columns);
  if (status) status = check("summary", select_rows("summary", version_, kOfBlock), kSummaryCheck, block.sums);
  return status;
}

Result<std::uint64_t> RecordingReader::verify() {
  if (salvaged_) return tl::unexpected(damaged_row().error());
  std::string found;
  auto status = each("PRAGMA integrity_check(1)", [&](const SqlStatement& row) { found = row.text(0); });
  if (status && found != "ok") status = damaged_recording(database_, Reason::verbatim(found));
  RecordingInfo about;
  if (status) {
    const auto held = hold();
    if (!held) return tl::unexpected(held.error());
    status = read_about(about);
    if (status) status = read_told(about);
    // Other tools read them.
    for (const auto* const table : {"signal", "series"}) {
      if (status) status = each_row(table, "", [](const SqlStatement&) {});
    }
  }
  if (status && !damage_.empty()) status = damaged_row();
  std::uint64_t count = 0;
  std::vector<CycleSample> samples;
  if (status) {
    status = blocks([&](const Block& block) -> Status {
      if (auto read = read_block(block, samples); !read) return read;
      if (auto read = check_rows(block); !read) return read;
      if (!damage_.empty()) return damaged_row();
      ++count;
      return check_sums(block, samples);
    });
  }
  if (status && !damage_.empty()) status = damaged_row();
  if (status) {
    status = each("SELECT max(id) FROM data", [&](const SqlStatement& row) -> Status {
      if (row.is_null(0) || row.integer(0) / kSeriesPerBlock < static_cast<std::int64_t>(count)) return {};
      return damaged_recording(database_, because("there are values of blocks that are not there"));
    });
  }
  for (const auto& signal : signals()) {
    const bool of_slaves = signal.scope == SignalInfo::Scope::kSlave;
    if (!status || (!of_slaves && signal.of_bus == nullptr)) continue;
    const auto slaves = of_slaves ? static_cast<int>(about.about.slaves.size()) : 0;
    for (int slave = of_slaves ? 0 : -1; status && slave < slaves; ++slave) {
      if (const auto read = points(signal.id, slave); !read) status = tl::unexpected(read.error());
    }
  }
  if (!status) return tl::unexpected(status.error());
  return count;
}

}  // namespace syncline
