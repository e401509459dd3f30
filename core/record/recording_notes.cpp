// SPDX-License-Identifier: Apache-2.0
#include "record/recording_notes.h"

#include <string>
#include <utility>

#include "record/recording_rows.h"
#include "record/recording_schema.h"
#include "record/run_note.h"
#include "sqlite/sqlite_database.h"

namespace syncline {
namespace {

Status replace_all(SqlDatabase& database, std::int64_t version, std::span<const RunNote> notes) {
  const bool checked = version >= kFirstWithChecks;
  auto transaction = SqlTransaction::begin(database);
  if (!transaction) return tl::unexpected(transaction.error());
  if (auto status = database.execute("DELETE FROM note"); !status) return status;
  auto row = database.prepare(checked ? insert_row("note")
                                      : std::string("INSERT INTO note(id, time_ns, text) VALUES(?, ?, ?)"));
  if (!row) return tl::unexpected(row.error());
  std::int64_t number = 0;
  for (const auto& note : notes) {
    if (auto status = row->bind(0, ++number).bind(1, note.time).bind(2, note.text).run(); !status) return status;
  }
  row->reset();
  RowTally tally;
  tally.clear("note");
  tally.add("note", number);
  if (checked) {
    if (auto status = tally.write(database); !status) return status;
  }
  return transaction->commit();
}

}  // namespace

Status write_notes(const std::string& path, std::span<const RunNote> notes) {
  // Looked at first: what is no recording, or a newer one, is not touched.
  std::int64_t version = 0;
  {
    auto readable = open_recording(path);
    if (!readable) return tl::unexpected(readable.error());
    const auto told = recording_version(*readable);
    if (!told) return read_error(*readable, told.error());
    version = *told;
  }
  auto database = SqlDatabase::open(path);
  if (!database) {
    return fail(Error{.code = ErrorCode::kFileNotWritable, .detail = database.error().detail, .file = path});
  }
  // Nobody else may have it open: one that is being written gets its notes from who writes it, and
  // nobody waits for that.
  auto status = database->execute("PRAGMA busy_timeout=0; PRAGMA locking_mode=EXCLUSIVE;");
  if (status) status = replace_all(*database, version, notes);
  // What was cut short has a log beside it still; from here on it is one file.
  if (status) status = database->execute("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode=DELETE;");
  if (!status) return write_error(*database, status.error());
  return {};
}

}  // namespace syncline
