// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "channels/cycle_sample.h"
#include "record/recording.h"
#include "support/result.h"

/// Runs out of files that are no recordings. What such a file does not hold has no value (core/trace/untold.h): nothing
/// is zero because nobody knows it.
namespace syncline {

struct ReplayedRun;

/// What the run is to be held against, which no such file tells, and how much of the file is taken.
struct ImportLimits {
  std::uint32_t deviation_ns = 0;  // of the slaves; 0: not known
  Nanoseconds dcm_error_ns = 0;    // of the master; 0: not known
  /// Of captures: which part of the file is taken. Times since its first frame, 0 <= from; until 0: to its end.
  Nanoseconds from = 0, until = 0;
  std::uint64_t most_frames = 0;  // from there on; 0: all
};

struct ImportedRun {
  RecordingAbout about;
  std::vector<CycleSample> samples;
  std::vector<Finding> findings{};  // about the file: what of it is lost
};

enum class TableKind : std::uint8_t {
  kDcmLog,    // of the master synchronisation, ours and EC-Master's
  kRunTable,  // "run --csv", "record export"
};
/// By its first line.
[[nodiscard]] std::optional<TableKind> table_kind(std::string_view text);

/// `name`: of the file, in UTF-8 with or without its mark. A last line without an end is a finding, left out where it
/// is not complete. kMalformedData with the line, also where one has too few cells; kNotThatKindOfFile where it is none
/// of the tables, kBadValue where it has no rows, or their times do not tell the cycles apart.
[[nodiscard]] Result<ImportedRun> import_table(std::string_view text, const std::string& name,
                                               const ImportLimits& limits = {});

/// The distance of most neighbours, by their times and numbers, rounded to what cycle times are; 0: there are none.
[[nodiscard]] Nanoseconds cycle_time_of(const std::vector<CycleSample>& samples);
/// Numbers cycles that have none by their times: where some are missing, so many numbers are left out.
void count_cycles(std::vector<CycleSample>& samples);

/// As if it had been recorded and opened: with slaves by their numbers, no events, and findings about the file alone.
[[nodiscard]] ReplayedRun replayed(const ImportedRun& run);
/// Before much is read for it: whether write_recording() would make a file of this name. kFileNotWritable.
[[nodiscard]] Status may_write_recording(const std::string& path);
/// To a new recording, or to none. As RecordingWriter::create() and write().
[[nodiscard]] Status write_recording(const ImportedRun& run, const std::string& path);

}  // namespace syncline
