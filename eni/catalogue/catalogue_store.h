// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sqlite/sqlite_database.h"

/// The tables behind the catalogue: a cache that can be made again from the ESI files at any time.
namespace syncline::eni {

struct EsiCard;
struct EsiCards;
struct FileWarning;

struct IndexedFile {
  std::int64_t id = 0;
  std::int64_t size = 0;
  std::int64_t changed_ns = 0;  // modification time; kUncertain = read it again
  std::uint64_t content = 0;
  static constexpr std::int64_t kUncertain = -1;
};

class CatalogueStore {
 public:
  /// "" is in memory. A database that is damaged or of another version is replaced by an empty one, which
  /// remembers the folders of the one before where it could be read, and `replaced` says why; a file that is no
  /// catalogue of ours is refused (kCatalogue) and stays as it is.
  [[nodiscard]] static Result<CatalogueStore> open(const std::string& path, Reason& replaced);

  [[nodiscard]] SqlDatabase& database() { return database_; }

  [[nodiscard]] Result<std::optional<IndexedFile>> file(std::string_view path);
  /// Forgets what was known of the file and stores this. The file's id.
  [[nodiscard]] Result<std::int64_t> put(std::string_view path, const IndexedFile& file, const EsiCards& cards);
  /// Fingerprints of the file's devices (read_contents), for when they are needed again.
  [[nodiscard]] Status put_contents(std::string_view path, const std::vector<std::uint64_t>& contents);
  [[nodiscard]] Status touch(std::int64_t file, std::int64_t changed_ns);
  [[nodiscard]] Status remove(std::int64_t file);
  /// Files below a folder, by path.
  [[nodiscard]] Result<std::vector<std::pair<std::string, IndexedFile>>> files_below(std::string_view folder);

  /// For a search that names none.
  [[nodiscard]] Result<std::vector<std::string>> folders();
  [[nodiscard]] Status remember_folder(std::string_view folder);
  /// Takes the folder and its files out.
  [[nodiscard]] Status forget_folder(std::string_view folder);

  /// Only chosen files are searched, in the order in which they were chosen. Lasts as long as this object.
  [[nodiscard]] Status choose(std::int64_t file);
  [[nodiscard]] Result<std::size_t> device_count();
  /// An error that is_damaged() where SQLite finds fault with any page or index, or the search has lost its words.
  [[nodiscard]] Status check();
  [[nodiscard]] Result<std::vector<FileWarning>> problems();

 private:
  explicit CatalogueStore(SqlDatabase database) : database_(std::move(database)) {}
  [[nodiscard]] Status clear(std::int64_t file);
  [[nodiscard]] Status put_device(std::int64_t file, const EsiCard& card);

  SqlDatabase database_;
};

/// $XDG_CACHE_HOME/syncline/esi-catalogue.sqlite, else below ~/.cache; "" when there is no home.
[[nodiscard]] std::string default_catalogue_path();

}  // namespace syncline::eni
