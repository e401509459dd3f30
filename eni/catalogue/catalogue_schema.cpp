// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/catalogue_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

#include "reasons/because.h"
#include "sqlite/database_files.h"
#include "sqlite/sqlite_database.h"

namespace syncline::eni {
namespace {

constexpr int kApplicationId = 0x53594E43;  // "SYNC", SQLite's place for whose file it is
constexpr int kSchemaVersion = 5;           // other versions are thrown away: a cache needs no migration

constexpr const char* kTables = R"(
CREATE TABLE folders(path TEXT PRIMARY KEY);
CREATE TABLE files(id INTEGER PRIMARY KEY, path TEXT NOT NULL UNIQUE, size INTEGER, changed_ns INTEGER, content INTEGER);
CREATE TABLE devices(id INTEGER PRIMARY KEY, file INTEGER NOT NULL, line INTEGER, place INTEGER, vendor_id INTEGER, product_code INTEGER,
  revision_no INTEGER, vendor_name TEXT, type TEXT COLLATE NOCASE, name TEXT, group_type TEXT, group_name TEXT, physics TEXT,
  revision_rule TEXT, invisible INTEGER, content INTEGER);
CREATE INDEX devices_by_file ON devices(file, place);
CREATE INDEX devices_by_identity ON devices(vendor_id, product_code, revision_no);
CREATE INDEX devices_by_type ON devices(type, revision_no);
CREATE INDEX devices_by_group ON devices(group_type);
CREATE TABLE hides(device INTEGER NOT NULL, vendor_id INTEGER, product_code INTEGER, revision_no INTEGER);
CREATE INDEX hides_by_device ON hides(device);
CREATE INDEX hides_by_identity ON hides(vendor_id, product_code, revision_no);
CREATE TABLE problems(file INTEGER NOT NULL, line INTEGER, element TEXT, text TEXT, words BLOB);
CREATE INDEX problems_by_file ON problems(file);
CREATE VIRTUAL TABLE words USING fts5(text, detail=none, columnsize=0, prefix='1 2 3', tokenize='unicode61 remove_diacritics 2');
)";

/// Of the first page of each of our files, whatever its version.
constexpr std::string_view kOwnTable = "CREATE TABLE hides(device INTEGER NOT NULL, vendor_id INTEGER";

// A cache may lose its last transaction with the power, not with the program: no waiting for the disk.
constexpr const char* kConnection = R"(
PRAGMA synchronous=OFF;
PRAGMA temp_store=MEMORY;
CREATE TEMP TABLE chosen(rank INTEGER PRIMARY KEY, file INTEGER UNIQUE);
)";

enum class Owner { kNobody, kUs, kOthers };

constexpr std::size_t kPage = 4096;  // SQLite's, as we make it

/// From the file's first page alone, so that a damaged one is known too: SQLite keeps the application id at offset 68
/// and, behind its header, the statements that made the tables. A text has no zeros, as the rest of that page has.
Owner owner_of(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size == 0) return Owner::kNobody;
  std::array<char, kPage> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  const std::string_view page(bytes.data(), std::min<std::uintmax_t>(size, bytes.size()));
  std::uint32_t id = 0;
  for (std::size_t i = 68; i < 72; ++i) id = id << 8 | static_cast<std::uint8_t>(bytes[i]);
  if (page.starts_with("SQLite format 3")) return id == kApplicationId ? Owner::kUs : Owner::kOthers;
  const bool headless =
      size % kPage == 0 && page.find('\0') != std::string_view::npos && page.find(kOwnTable) != std::string_view::npos;
  return headless ? Owner::kUs : Owner::kOthers;
}

Status make_tables(SqlDatabase& database) {
  auto transaction = SqlTransaction::begin(database);
  if (!transaction) return tl::unexpected(transaction.error());
  // Somebody else may have made them while we waited.
  const auto version = database.number("PRAGMA user_version");
  if (!version) return tl::unexpected(version.error());
  if (*version == 0) {
    if (auto status = database.execute(kTables); !status) return status;
    const auto mark = fmt::format("PRAGMA application_id={}; PRAGMA user_version={};", kApplicationId, kSchemaVersion);
    if (auto status = database.execute(mark.c_str()); !status) return status;
  }
  return transaction->commit();
}

/// Opened, with tables; `reason` says why it is to be made again.
Result<SqlDatabase> try_open(const std::string& path, Reason& reason) {
  auto database = SqlDatabase::open(path);
  if (!database) return database;
  const auto version = database->number("PRAGMA user_version");
  if (!version) return tl::unexpected(version.error());
  if (*version == 0) {
    if (auto status = make_tables(*database); !status) return tl::unexpected(status.error());
  } else if (*version != kSchemaVersion) {
    reason = because("it is of version {version}, this program uses version {own}", *version, kSchemaVersion);
  }
  if (auto status = database->execute(kConnection); !status) return tl::unexpected(status.error());
  return database;
}

/// The folders that the user had it remember: what is read in them is found again, that they are wanted is not.
std::vector<std::string> remembered_folders(SqlDatabase& database) {
  std::vector<std::string> found;
  auto query = database.prepare("SELECT path FROM folders ORDER BY rowid");
  if (query) (void)query->each([&] { found.emplace_back(query->text(0)); });
  return found;
}

Status remember(SqlDatabase& database, const std::vector<std::string>& folders) {
  for (const auto& folder : folders) {
    auto query = database.prepare("INSERT OR IGNORE INTO folders VALUES(?)");
    if (!query) return tl::unexpected(query.error());
    if (auto status = query->bind(0, folder).run(); !status) return status;
  }
  return {};
}

}  // namespace

Result<SqlDatabase> open_catalogue_database(const std::string& path, Reason& replaced) {
  const bool named_as_ours =
      std::filesystem::path(path).extension() == ".sqlite" && path.find("esi-catalogue") != std::string::npos;
  if (!path.empty() && owner_of(path) == Owner::kOthers && !named_as_ours) {
    return fail(Error{.code = ErrorCode::kCatalogue,
                      .detail = because("it is no device catalogue, or its beginning is damaged"),
                      .file = path});
  }
  auto database = try_open(path, replaced);
  if (!database && is_damaged(database.error())) replaced = because("it was damaged: {words}", database.error().detail);
  if (replaced.empty()) return database;
  std::vector<std::string> folders;
  if (database) {
    folders = remembered_folders(*database);
    *database = {};  // closed before its file goes
  }
  remove_database(path);
  Reason again;
  database = try_open(path, again);
  if (database) {
    if (auto status = remember(*database, folders); !status) return tl::unexpected(status.error());
  }
  return database;
}

}  // namespace syncline::eni
