// SPDX-License-Identifier: Apache-2.0
#include "sqlite/sqlite_database.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "reasons/because.h"
#include "sqlite/row_check.h"
#include "support/attempt.h"

namespace syncline {
namespace {

constexpr int kBusyTimeoutMs = 10'000;  // another program may be indexing the same folders

tl::unexpected<Error> sql_error(sqlite3* database, int code) {
  const char* const name = database ? sqlite3_db_filename(database, "main") : nullptr;
  // A file that ends within a page is damage, no trouble of the disk.
  if (database && sqlite3_extended_errcode(database) == SQLITE_IOERR_SHORT_READ) code = SQLITE_CORRUPT;
  return fail(Error{.code = ErrorCode::kCatalogue,
                    .detail = Reason::verbatim(std::string(database ? sqlite3_errmsg(database) : sqlite3_errstr(code))),
                    .file = name ? name : "",
                    .received = code & 0xFF});
}

/// SQLite would write its pages into a device, and its log beside it.
Status check_ordinary(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (path.empty() || error || !std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return {};
  return fail(Error{.code = ErrorCode::kFileNotWritable, .detail = because("it is no ordinary file"), .file = path});
}

}  // namespace

SqlStatement& SqlStatement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(statement_, parameter + 1, value);
  return *this;
}

SqlStatement& SqlStatement::bind(int parameter, std::string_view text) {
  // An empty text, not NULL, where the view has no storage.
  sqlite3_bind_text(statement_, parameter + 1, text.empty() ? "" : text.data(), static_cast<int>(text.size()),
                    SQLITE_TRANSIENT);
  return *this;
}

SqlStatement& SqlStatement::bind_real(int parameter, double value) {
  sqlite3_bind_double(statement_, parameter + 1, value);
  return *this;
}

SqlStatement& SqlStatement::bind_blob(int parameter, std::string_view bytes) {
  sqlite3_bind_blob64(statement_, parameter + 1, bytes.empty() ? "" : bytes.data(), bytes.size(), nullptr);
  return *this;
}

SqlStatement& SqlStatement::bind_null(int parameter) {
  sqlite3_bind_null(statement_, parameter + 1);
  return *this;
}

Result<bool> SqlStatement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return sql_error(sqlite3_db_handle(statement_), code);
}

Status SqlStatement::run() {
  const auto done = step();
  reset();
  if (!done) return tl::unexpected(done.error());
  return {};
}

std::int64_t SqlStatement::integer(int column) const { return sqlite3_column_int64(statement_, column); }

std::string_view SqlStatement::text(int column) const {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return text ? std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
              : std::string_view{};
}

double SqlStatement::real(int column) const { return sqlite3_column_double(statement_, column); }

std::string_view SqlStatement::blob(int column) const {
  const auto* const bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  return bytes ? std::string_view(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
               : std::string_view{};
}

bool SqlStatement::is_null(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }

void SqlStatement::reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

void SqlDatabase::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void SqlDatabase::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Result<SqlDatabase> SqlDatabase::open(const std::string& path) {
  if (auto status = check_ordinary(path); !status) return tl::unexpected(status.error());
  return open_with(path, path.empty() ? ":memory:" : path.c_str(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

Result<SqlDatabase> SqlDatabase::open_to_read(const std::string& path) {
  return open_with(path, path.empty() ? ":memory:" : path.c_str(), SQLITE_OPEN_READONLY);
}

Result<SqlDatabase> SqlDatabase::open_temporary(const std::string& path) {
  return open_with(path, "", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

Result<SqlDatabase> SqlDatabase::open_with(const std::string& path, const char* file, int flags) {
  SqlDatabase opened;
  opened.path_ = path;
  sqlite3* database = nullptr;
  int code = sqlite3_open_v2(file, &database, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  opened.database_.reset(database);
  if (code == SQLITE_OK) code = add_row_crc(database);
  if (code != SQLITE_OK) {
    auto error = sql_error(database, code);
    error.value().file = path;
    return error;
  }
  sqlite3_busy_timeout(database, kBusyTimeoutMs);
  return opened;
}

Status SqlDatabase::execute(const char* sql) {
  const int code = sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) return sql_error(database_.get(), code);
  return {};
}

Result<SqlStatement> SqlDatabase::prepare(std::string_view sql) {
  auto found = statements_.find(sql);
  if (found == statements_.end()) found = statements_.emplace(sql, nullptr).first;
  auto& known = found->second;
  if (!known) {
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v3(database_.get(), sql.data(), static_cast<int>(sql.size()),
                                        SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
    if (code != SQLITE_OK) return sql_error(database_.get(), code);
    known.reset(statement);
  }
  SqlStatement statement(known.get());
  statement.reset();
  return statement;
}

Result<std::int64_t> SqlDatabase::number(std::string_view sql) {
  auto statement = prepare(sql);
  if (!statement) return tl::unexpected(statement.error());
  std::int64_t value = 0;
  if (auto status = statement->each([&] { value = statement->integer(0); }); !status)
    return tl::unexpected(status.error());
  return value;
}

std::int64_t SqlDatabase::last_row() const { return sqlite3_last_insert_rowid(database_.get()); }

bool is_damaged(const Error& error) {
  if (error.code != ErrorCode::kCatalogue) return false;
  // The statements are always the same: that one of them is wrong, or breaks a rule, lies in what it found.
  constexpr int kDamages[] = {SQLITE_CORRUPT,    SQLITE_NOTADB,   SQLITE_ERROR,
                              SQLITE_CONSTRAINT, SQLITE_MISMATCH, SQLITE_FORMAT};
  return std::ranges::find(kDamages, error.received) != std::end(kDamages);
}

tl::unexpected<Error> damaged(const SqlDatabase& database, Reason detail) {
  return fail(Error{
      .code = ErrorCode::kCatalogue, .detail = std::move(detail), .file = database.path(), .received = SQLITE_CORRUPT});
}

Result<SqlTransaction> SqlTransaction::begin(SqlDatabase& database) {
  if (auto status = database.execute("BEGIN IMMEDIATE"); !status) return tl::unexpected(status.error());
  return SqlTransaction(database);
}

Result<SqlTransaction> SqlTransaction::begin_reading(SqlDatabase& database) {
  if (auto status = database.execute("BEGIN"); !status) return tl::unexpected(status.error());
  return SqlTransaction(database);
}

SqlTransaction::~SqlTransaction() {
  if (database_ != nullptr) attempt([this] { return database_->execute("ROLLBACK"); });
}

Status SqlTransaction::commit() {
  auto status = database_->execute("COMMIT");
  if (status) database_ = nullptr;
  return status;
}

}  // namespace syncline
