// SPDX-License-Identifier: Apache-2.0
// What a reader notes of rows that are not as they were written.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "findings/reason_of.h"
#include "findings/recording_words.h"
#include "findings/sentence.h"
#include "reasons/because.h"
#include "record/recording_reader.h"

namespace syncline {
namespace {

/// More are no news: the file is good for nothing.
constexpr std::size_t kMostDamage = 1000;

Finding at(Finding finding, const RecordingReader::Block& block) {
  finding.from = block.begin;
  finding.to = block.end;
  return finding;
}

}  // namespace

void RecordingReader::note(std::string table, std::string row, Finding finding) {
  if (damage_.size() >= kMostDamage) return;
  if (damaged_rows_.emplace(std::move(table), std::move(row)).second) damage_.push_back(std::move(finding));
}

void RecordingReader::note_row(std::string_view table, const SqlStatement& row) {
  const std::string key(row.text(0));
  note(std::string(table), key,
       make_finding<words::kRecording>("recording-damaged", {}, fig::text<"row">(key),
                                       fig::text<"table">(std::string(table))));
}

void RecordingReader::note_gap(std::string_view table, std::string_view row, const Block& block) {
  const std::string key(row);
  note(std::string(table), key,
       at(make_finding<words::kRecording>("recording-damaged/gap", {}, fig::text<"row">(key),
                                          fig::text<"table">(std::string(table)),
                                          fig::count<"first">(block.first_cycle), fig::count<"last">(block.last_cycle)),
          block));
}

void RecordingReader::note_series(std::string_view row, std::int64_t series, const Block& block) {
  const auto signal = static_cast<std::size_t>(std::max<std::int64_t>(series, 0) % kBusSeries);
  const std::string key(row);
  note("data", key,
       at(make_finding<words::kRecording>(
              "recording-damaged/series", {}, fig::text<"row">(key), fig::text<"table">("data"),
              fig::text<"signal">(std::string(signal < kSignalCount ? signals()[signal].key : "?")),
              fig::count<"first">(block.first_cycle), fig::count<"last">(block.last_cycle)),
          block));
}

void RecordingReader::note_missing(std::string_view table, std::int64_t there) {
  const auto counted = tally_.find(table);
  if (counted == tally_.end() || there >= counted->second) return;
  note(std::string(table), "missing",
       make_finding<words::kRecording>("recording-damaged/missing", {},
                                       fig::count<"count">(static_cast<std::uint64_t>(counted->second - there)),
                                       fig::text<"table">(std::string(table))));
}

void RecordingReader::note_block(const Block& block, std::int64_t missing) {
  const auto first = fig::count<"first">(block.first_cycle);
  const auto last = fig::count<"last">(block.last_cycle);
  const auto number = fmt::format("of {}", block.number);
  if (missing > 0) {
    const auto count = fig::count<"count">(static_cast<std::uint64_t>(missing));
    return note("data", number,
                at(make_finding<words::kRecording>("recording-damaged/missing-gap", {}, count,
                                                   fig::text<"table">("data"), first, last),
                   block));
  }
  note("data", number,
       at(make_finding<words::kRecording>("recording-damaged/block", {}, fig::number<"block">(block.number), first,
                                          last),
          block));
}

Status RecordingReader::salvage(Error otherwise) {
  if (salvaged_) return tl::unexpected(std::move(otherwise));
  auto salvaged = salvage_recording(path());
  if (!salvaged) return tl::unexpected(std::move(otherwise));
  if (salvaged->cycles == 0) return no_cycle_left(path());
  database_ = std::move(salvaged->database);
  damage_.clear();
  damaged_rows_.clear();
  note_cut(*salvaged);
  return {};
}

void RecordingReader::note_cut(const SalvagedRecording& salvaged) {
  salvaged_ = true;
  const auto kib = [](std::uint64_t bytes) { return bytes / 1024; };
  const auto cycles = fig::count<"cycles">(salvaged.cycles);
  const auto lost = fig::count<"count">(salvaged.blocks_lost);
  if (salvaged.bytes_said == 0)
    return note("file", "cut", make_finding<words::kRecording>("recording-cut-off/pages", {}, cycles, lost));
  note("file", "cut",
       make_finding<words::kRecording>("recording-cut-off", {}, fig::count<"there">(kib(salvaged.bytes)),
                                       fig::count<"all">(kib(salvaged.bytes_said)), cycles, lost));
}

std::vector<Finding> RecordingReader::found() const {
  auto all = damage_;
  if (log_missing_ && !ended_) {
    const auto log = std::filesystem::path(path()).filename().string() + "-wal";
    all.push_back(make_finding<words::kRecording>("recording-log-missing", {}, fig::text<"file">(log)));
  }
  if (!is_checked())
    all.push_back(make_finding<words::kRecording>("recording-unchecked", {}, fig::number<"version">(version_)));
  return all;
}

Status RecordingReader::as_error(const Finding& damage) const {
  return damaged_recording(database_, facts_reason(damage));
}

Status RecordingReader::read_tally() {
  if (!is_checked()) return {};
  tally_.clear();
  if (auto status =
          each_row("tally", "", [&](const SqlStatement& row) { tally_[std::string(row.text(0))] = row.integer(1); });
      !status)
    return status;
  tally_["tally"] = RowTally::kTables;
  note_missing("tally", static_cast<std::int64_t>(tally_.size()) - 1);
  return {};
}

}  // namespace syncline
