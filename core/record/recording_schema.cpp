// SPDX-License-Identifier: Apache-2.0
#include "record/recording_schema.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "findings/reason_of.h"
#include "findings/recording_words.h"
#include "findings/sentence.h"
#include "reasons/because.h"
#include "sqlite/database_files.h"
#include "sqlite/sqlite_database.h"

namespace syncline {
namespace {

// All is appended, so that what was written once is never touched again.
constexpr const char* kTables = R"(
BEGIN;
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE document(kind TEXT PRIMARY KEY, name TEXT NOT NULL, body BLOB NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE limits(key TEXT PRIMARY KEY, value INTEGER NOT NULL, unit TEXT NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE slave(position INTEGER PRIMARY KEY, name TEXT NOT NULL, vendor_id INTEGER, product_code INTEGER, revision_no INTEGER, crc INTEGER NOT NULL);
CREATE TABLE signal(id INTEGER PRIMARY KEY, key TEXT NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL, scope TEXT NOT NULL,
  form TEXT NOT NULL, source TEXT NOT NULL, since TEXT NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE series(id INTEGER PRIMARY KEY, signal INTEGER NOT NULL, slave INTEGER, crc INTEGER NOT NULL);
CREATE TABLE variable(id INTEGER PRIMARY KEY, name TEXT NOT NULL, slave INTEGER, direction TEXT NOT NULL,
  data_type TEXT NOT NULL, bit_offset INTEGER NOT NULL, bit_size INTEGER NOT NULL, series INTEGER NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE watch_list(number INTEGER NOT NULL, place INTEGER NOT NULL, variable INTEGER NOT NULL, crc INTEGER NOT NULL, PRIMARY KEY(number, place));
CREATE TABLE block(number INTEGER PRIMARY KEY, first_cycle INTEGER NOT NULL, last_cycle INTEGER NOT NULL, cycles INTEGER NOT NULL,
  begin_ns INTEGER NOT NULL, end_ns INTEGER NOT NULL, columns INTEGER NOT NULL, held INTEGER NOT NULL, sums INTEGER NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE summary(id INTEGER PRIMARY KEY, count INTEGER NOT NULL, min REAL, max REAL, last REAL, crc INTEGER NOT NULL);
CREATE TABLE data(id INTEGER PRIMARY KEY, codec INTEGER NOT NULL, count INTEGER NOT NULL, times BLOB, cells BLOB, levels BLOB, crc INTEGER NOT NULL, levels_crc INTEGER NOT NULL);
CREATE TABLE event(id INTEGER PRIMARY KEY, time_ns INTEGER NOT NULL, slave INTEGER, kind TEXT NOT NULL, text TEXT NOT NULL,
  details BLOB, crc INTEGER NOT NULL);
CREATE TABLE finding(id INTEGER PRIMARY KEY, code TEXT NOT NULL, level TEXT NOT NULL, slave INTEGER, text TEXT NOT NULL,
  details BLOB, crc INTEGER NOT NULL);
CREATE TABLE note(id INTEGER PRIMARY KEY, time_ns INTEGER NOT NULL, text TEXT NOT NULL, crc INTEGER NOT NULL);
CREATE TABLE tally(name TEXT PRIMARY KEY, count INTEGER NOT NULL, crc INTEGER NOT NULL);
COMMIT;
)";

// In WAL mode a commit is whole or not there, whatever kills the program; NORMAL keeps the order on the disk, too.
constexpr const char* kConnection = "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL; PRAGMA temp_store=MEMORY;";

/// By the file's first bytes, so that a damaged one is known too; a log beside it may hold the rest.
Status look_at(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return fail(Error{.code = ErrorCode::kFileNotFound, .file = path});
  std::array<char, 16> header{};
  std::ifstream file;
  // A pipe is no recording, and would be waited for.
  const bool ordinary = std::filesystem::is_regular_file(path, error);
  if (ordinary) file.open(path, std::ios::binary);
  file.read(header.data(), header.size());
  if (!ordinary || !file.good() || std::string_view(header.data(), 15) != "SQLite format 3") {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .detail = because("a recording that \"synclinectl run --record\" has written"),
                      .file = path});
  }
  return {};
}

/// Whether the rows of a file have checks, whatever its version says.
Result<bool> has_checks(SqlDatabase& database) {
  auto columns = database.number("SELECT count(*) FROM pragma_table_info('block') WHERE name = 'crc'");
  if (!columns) return tl::unexpected(columns.error());
  return *columns > 0;
}

}  // namespace

bool lacks_log(const std::string& path) {
  constexpr std::streamoff kReadVersion = 19;  // of SQLite's header; 2: with a log
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  file.seekg(kReadVersion);
  if (file.get() != 2) return false;
  const auto size = std::filesystem::file_size(path + "-wal", error);
  return error || size == 0;
}

tl::unexpected<Error> read_error(const SqlDatabase& database, const Error& error) {
  const bool damaged = is_damaged(error);
  auto detail = damaged ? because("it is damaged or cut off ({words})", error.detail) : error.detail;
  return fail(Error{.code = ErrorCode::kFileNotReadable,
                    .detail = std::move(detail),
                    .file = database.path(),
                    .received = error.received});
}

tl::unexpected<Error> write_error(const SqlDatabase& database, const Error& error) {
  return fail(Error{.code = ErrorCode::kFileNotWritable,
                    .detail = error.detail,
                    .file = database.path(),
                    .received = error.received});
}

tl::unexpected<Error> damaged_recording(const SqlDatabase& database, Reason what) {
  return fail(Error{.code = ErrorCode::kFileNotReadable,
                    .detail = because("it is damaged: {words}", std::move(what)),
                    .file = database.path()});
}

tl::unexpected<Error> no_cycle_left(const std::string& path) {
  return fail(Error{.code = ErrorCode::kFileNotReadable,
                    .detail = because("it is damaged or cut off ({words})",
                                      facts_reason(make_finding<words::kRecording>("recording-cut-off/nothing", {}))),
                    .file = path});
}

Status check_new_recording(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  return fail(Error{.code = ErrorCode::kFileNotWritable,
                    .detail = because("there is one of this name already, and a recording replaces nothing"),
                    .file = path});
}

Result<SqlDatabase> create_recording(const std::string& path) {
  if (auto status = check_new_recording(path); !status) return tl::unexpected(status.error());
  auto database = SqlDatabase::open(path);
  if (!database) {
    return fail(Error{.code = ErrorCode::kFileNotWritable, .detail = database.error().detail, .file = path});
  }
  const auto mark = fmt::format("PRAGMA page_size=8192; PRAGMA application_id={}; PRAGMA user_version={};",
                                kRecordingId, kRecordingVersion);
  // The tables before the log is begun: a file whose log is lost is a recording all the same.
  for (const char* const sql : {mark.c_str(), kTables, kConnection}) {
    if (auto status = database->execute(sql); !status) {
      database = write_error(*database, status.error());  // closed before its file goes
      remove_database(path);
      return database;
    }
  }
  return database;
}

Result<SqlDatabase> create_salvage(const std::string& path) {
  auto database = SqlDatabase::open_temporary(path);
  if (!database) return tl::unexpected(database.error());
  const auto mark =
      fmt::format("PRAGMA page_size=8192; PRAGMA journal_mode=OFF; PRAGMA application_id={}; PRAGMA user_version={};",
                  kRecordingId, kRecordingVersion);
  for (const char* const sql : {mark.c_str(), kTables}) {
    if (auto status = database->execute(sql); !status) return read_error(*database, status.error());
  }
  return database;
}

Result<std::int64_t> recording_version(SqlDatabase& database) { return database.number("PRAGMA user_version"); }

Result<SqlDatabase> open_recording(const std::string& path) {
  if (auto status = look_at(path); !status) return tl::unexpected(status.error());
  auto database = SqlDatabase::open_to_read(path);
  if (!database) {
    return fail(Error{.code = ErrorCode::kFileNotReadable, .detail = database.error().detail, .file = path});
  }
  const auto id = database->number("PRAGMA application_id");
  if (!id) return read_error(*database, id.error());
  if (*id != kRecordingId) {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .detail = because("a recording; this database belongs to another program"),
                      .file = path});
  }
  const auto version = recording_version(*database);
  if (!version) return read_error(*database, version.error());
  if (*version < 1 || *version > kRecordingVersion) {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .detail = because("a recording of version {version} or older; this one is of version {other}, "
                                        "use the program that has written it, or a newer one",
                                        kRecordingVersion, *version),
                      .file = path});
  }
  const auto checks = has_checks(*database);
  if (!checks) return read_error(*database, checks.error());
  if (*checks != (*version >= kFirstWithChecks))
    return damaged_recording(*database, because("its tables are not those of version {version}", *version));
  return database;
}

}  // namespace syncline
