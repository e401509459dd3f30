// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "support/result.h"
#include "trace/signals.h"

/// The tables of a recording (docs/recording.md), and whose file it is.
namespace syncline {

class SqlDatabase;

inline constexpr std::int64_t kRecordingId = 0x53594E52;  // "SYNR", SQLite's application_id
inline constexpr std::int64_t kRecordingVersion = 5;      // user_version
inline constexpr std::int64_t kFirstWithDetails = 2;      // of events and findings
inline constexpr std::int64_t kFirstWithVariables = 4;    // that were watched
inline constexpr std::int64_t kFirstWithChecks = 5;       // of every row
/// Rows of `summary` and `data`: block * kSeriesPerBlock + series.
inline constexpr std::int64_t kSeriesPerBlock = 1 << 20;
inline constexpr std::int64_t kMostBlockCycles = 1 << 16;
/// Cycles of one bucket of a block's min/max level.
inline constexpr std::size_t kLevelCycles = 256;

/// Numbers of the bus's series; each slave has as many behind them.
inline constexpr std::int64_t kBusSeries = 256;
/// Number of a signal's series, of the bus, of a slave, or of a variable by its number.
[[nodiscard]] constexpr std::int64_t series_number(Signal signal, int slave = -1) {
  return static_cast<std::int64_t>(signal) + (std::int64_t{slave} + 1) * kBusSeries;
}

/// kFileNotWritable: there is a file of this name.
[[nodiscard]] Status check_new_recording(const std::string& path);
/// A new file with empty tables, ready to be appended to. kFileNotWritable: it exists, or cannot be made.
[[nodiscard]] Result<SqlDatabase> create_recording(const std::string& path);
/// To be read. kFileNotFound, kNotThatKindOfFile: no recording, or one of a newer version; kFileNotReadable: damaged.
[[nodiscard]] Result<SqlDatabase> open_recording(const std::string& path);
/// An empty one that goes with its object, for what is salvaged of the recording of this name. kFileNotReadable: there
/// is no room for it.
[[nodiscard]] Result<SqlDatabase> create_salvage(const std::string& path);
/// Before it is opened: it is in WAL mode, and beside it is no log that holds anything. Where the recording was cut
/// short, that log is lost, or another program has taken it over.
[[nodiscard]] bool lacks_log(const std::string& path);
/// Of one that was opened: user_version.
[[nodiscard]] Result<std::int64_t> recording_version(SqlDatabase& database);

/// What SQLite says, as an error of reading or of writing this file.
[[nodiscard]] tl::unexpected<Error> read_error(const SqlDatabase& database, const Error& error);
[[nodiscard]] tl::unexpected<Error> write_error(const SqlDatabase& database, const Error& error);
[[nodiscard]] tl::unexpected<Error> damaged_recording(const SqlDatabase& database, Reason what);
/// kFileNotReadable: of what was recorded nothing can be shown.
[[nodiscard]] tl::unexpected<Error> no_cycle_left(const std::string& path);

}  // namespace syncline
