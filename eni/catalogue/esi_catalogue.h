// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "eni/catalogue/catalogue_entry.h"
#include "eni/catalogue/catalogue_match.h"
#include "support/result.h"

namespace syncline {
struct DeviceDescription;
}  // namespace syncline

namespace syncline::eni {

struct FileWarning;

struct DeviceMatch {
  const DeviceDescription* device = nullptr;  // lives as long as the catalogue
  bool exact_revision = false;
  MatchKind kind = MatchKind::kExact;
  std::string words;  // why this device
};

/// The devices of folders of ESI files: an index in SQLite finds them, the file of a device is read when somebody wants
/// all of it. For one thread at a time; several programs may use the same database.
class EsiCatalogue {
 public:
  /// With an index in memory.
  EsiCatalogue();
  /// With an index that stays in a file: folders are read once, then only what changed. A damaged database or one of
  /// another version is made again, warnings() says so; a file that is something else is refused (kCatalogue).
  [[nodiscard]] static Result<EsiCatalogue> open(const std::string& database);
  /// In default_catalogue_path(), or in memory with a warning where that cannot be used.
  [[nodiscard]] static EsiCatalogue open_default();
  EsiCatalogue(EsiCatalogue&&) noexcept;
  EsiCatalogue& operator=(EsiCatalogue&&) noexcept;
  ~EsiCatalogue();

  /// Adds every *.xml below a folder. A file that cannot be read becomes a warning; a missing folder is an error.
  Result<IndexReport> add_folder(const std::string& path, const IndexCallback& callback = {});
  Status add_file(const std::string& path);
  /// Folders that the user wants to be looked into whatever the task: kept in the database.
  [[nodiscard]] Result<std::vector<std::string>> known_folders() const;
  [[nodiscard]] Status remember_folder(const std::string& path);
  [[nodiscard]] Status forget_folder(const std::string& path);

  [[nodiscard]] std::size_t device_count() const;
  /// Of the files: what cannot be read, and what was tolerated in those that were read whole; behind notes().
  [[nodiscard]] std::vector<FileWarning> warnings() const;
  /// Of the database itself: made again, or not usable.
  [[nodiscard]] const std::vector<FileWarning>& notes() const;
  [[nodiscard]] const std::string& database() const;  // "" = in memory

  [[nodiscard]] Result<std::vector<CatalogueEntry>> search(const CatalogueSearch& search) const;
  /// `go_on` is asked between devices; with false from it the list is empty.
  [[nodiscard]] Result<std::vector<DuplicateDevice>> duplicates(const std::function<bool()>& go_on = {}) const;
  /// Looks through the whole database; one that is damaged anywhere is made again from the files, with a warning.
  [[nodiscard]] Status mend();
  /// See best_match(). kUnknownDevice when no file has the vendor's product.
  [[nodiscard]] Result<CatalogueMatch> match(const Identity& identity) const;
  /// The whole description from its file. Errors of the file; kXmlBadValue where its device cannot be read;
  /// kUnknownDevice when it went out of the file since.
  [[nodiscard]] Result<const DeviceDescription*> device(const CatalogueEntry& entry) const;
  /// match() and device() in one.
  [[nodiscard]] Result<DeviceMatch> device_for(const Identity& identity) const;
  /// The same for those who need no reason.
  [[nodiscard]] std::optional<DeviceMatch> find(const Identity& identity) const;

 private:
  struct State;
  explicit EsiCatalogue(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace syncline::eni
