// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/esi_catalogue.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "config/device_description.h"
#include "eni/catalogue/catalogue_query.h"
#include "eni/catalogue/catalogue_store.h"
#include "eni/catalogue/catalogue_update.h"
#include "eni/esi/esi_reader.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "reasons/because.h"
#include "sqlite/database_files.h"

namespace syncline::eni {

struct EsiCatalogue::State {
  struct Source {
    std::string path;
    bool is_folder = true;
  };

  std::string path;
  std::optional<CatalogueStore> store;
  std::vector<Source> sources;
  std::vector<FileWarning> notes;
  std::map<std::string, std::unique_ptr<EsiFile>> files;  // those that were read whole

  Status open() {
    Reason replaced;
    store.reset();
    auto opened = CatalogueStore::open(path, replaced);
    if (!opened) return tl::unexpected(opened.error());
    store = std::move(*opened);
    if (!replaced.empty()) warn_replaced(replaced);
    return {};
  }

  void warn_replaced(const Reason& reason) {
    notes.push_back({path, 0, {}, because("the device catalogue is made again: {reason}", reason)});
  }

  Status add(const Source& source) {
    if (!source.is_folder) return update_file(*store, source.path);
    const auto updated = update_folder(*store, source.path);
    return updated ? Status{} : Status(tl::unexpected(updated.error()));
  }

  /// A database may turn out to be damaged in the middle of anything: it is then made again, once, from the files.
  template <class Action>
  auto repaired(Action&& action) -> decltype(action()) {
    if (!store) {
      if (auto status = open(); !status) return tl::unexpected(status.error());
    }
    auto result = action();
    if (result || !is_damaged(result.error()) || path.empty()) return result;
    warn_replaced(because("it was damaged: {words}", result.error().detail));
    const auto wanted = store->folders().value_or(std::vector<std::string>{});  // as far as they can be read
    store.reset();
    remove_database(path);
    if (auto status = open(); !status) return tl::unexpected(status.error());
    for (const auto& folder : wanted) {
      if (auto status = store->remember_folder(folder); !status) return tl::unexpected(status.error());
    }
    for (const auto& source : sources) {
      if (auto status = add(source); !status) return tl::unexpected(status.error());
    }
    return action();
  }

  Result<const EsiFile*> file(const std::string& name) {
    auto& known = files[name];
    if (!known) {
      auto read = read_esi(name);
      if (!read) return tl::unexpected(read.error());
      known = std::make_unique<EsiFile>(std::move(*read));
    }
    return known.get();
  }
};

EsiCatalogue::EsiCatalogue() : state_(std::make_unique<State>()) {}
EsiCatalogue::EsiCatalogue(std::unique_ptr<State> state) : state_(std::move(state)) {}
EsiCatalogue::EsiCatalogue(EsiCatalogue&&) noexcept = default;
EsiCatalogue& EsiCatalogue::operator=(EsiCatalogue&&) noexcept = default;
EsiCatalogue::~EsiCatalogue() = default;

Result<EsiCatalogue> EsiCatalogue::open(const std::string& database) {
  auto state = std::make_unique<State>();
  state->path = database;
  std::error_code ignored;  // SQLite says what is wrong with the folder
  if (!database.empty()) std::filesystem::create_directories(std::filesystem::path(database).parent_path(), ignored);
  if (auto status = state->open(); !status) return tl::unexpected(status.error());
  return EsiCatalogue(std::move(state));
}

EsiCatalogue EsiCatalogue::open_default() {
  const auto path = default_catalogue_path();
  auto opened = open(path);
  if (opened) return std::move(*opened);
  EsiCatalogue in_memory;
  in_memory.state_->notes.push_back(
      {path, 0, {}, because("the ESI files are read anew each time: {error}", reason_of(opened.error()))});
  return in_memory;
}

Result<IndexReport> EsiCatalogue::add_folder(const std::string& path, const IndexCallback& callback) {
  std::error_code error;
  const auto canonical = std::filesystem::canonical(path, error);  // the database outlives this working folder
  const State::Source source{error ? path : canonical.string(), true};
  auto report = state_->repaired([&] { return update_folder(*state_->store, source.path, callback); });
  if (report) state_->sources.push_back(source);
  return report;
}

Status EsiCatalogue::add_file(const std::string& path) {
  std::error_code error;
  const auto canonical = std::filesystem::canonical(path, error);
  const State::Source source{error ? path : canonical.string(), false};
  auto status = state_->repaired([&] { return update_file(*state_->store, source.path); });
  if (status) state_->sources.push_back(source);
  return status;
}

Result<std::vector<std::string>> EsiCatalogue::known_folders() const {
  return state_->repaired([&] { return state_->store->folders(); });
}

Status EsiCatalogue::remember_folder(const std::string& path) {
  std::error_code error;
  const auto canonical = std::filesystem::weakly_canonical(path, error).string();
  return state_->repaired([&] { return state_->store->remember_folder(canonical); });
}

Status EsiCatalogue::forget_folder(const std::string& path) {
  std::error_code error;
  const auto canonical = std::filesystem::weakly_canonical(path, error).string();
  std::erase_if(state_->sources, [&](const auto& source) { return source.path == canonical; });
  return state_->repaired([&]() -> Status {
    auto transaction = SqlTransaction::begin(state_->store->database());
    if (!transaction) return tl::unexpected(transaction.error());
    if (auto status = state_->store->forget_folder(canonical); !status) return status;
    return transaction->commit();
  });
}

std::size_t EsiCatalogue::device_count() const {
  return state_->repaired([&] { return state_->store->device_count(); }).value_or(0);
}

std::vector<FileWarning> EsiCatalogue::warnings() const {
  auto indexed = state_->repaired([&] { return state_->store->problems(); });
  auto all = state_->notes;
  const auto add = [&](const std::vector<FileWarning>& more) {
    const std::size_t before = all.size();  // a broken device is found by the index and by the reader
    for (const auto& warning : more) {
      const auto same_place = [&](const FileWarning& w) { return w.file == warning.file && w.line == warning.line; };
      if (std::none_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(before), same_place))
        all.push_back(warning);
    }
  };
  if (indexed) add(*indexed);
  for (const auto& [name, file] : state_->files) {
    if (file) add(file->warnings);
  }
  return all;
}

const std::vector<FileWarning>& EsiCatalogue::notes() const { return state_->notes; }

const std::string& EsiCatalogue::database() const { return state_->path; }

Result<std::vector<CatalogueEntry>> EsiCatalogue::search(const CatalogueSearch& wanted) const {
  return state_->repaired([&] { return eni::search(*state_->store, wanted); });
}

Result<std::vector<DuplicateDevice>> EsiCatalogue::duplicates(const std::function<bool()>& go_on) const {
  return state_->repaired([&] { return eni::duplicates(*state_->store, go_on); });
}

Status EsiCatalogue::mend() {
  return state_->repaired([&] { return state_->store->check(); });
}

Result<CatalogueMatch> EsiCatalogue::match(const Identity& identity) const {
  const auto entries =
      state_->repaired([&] { return entries_of(*state_->store, identity.vendor_id, identity.product_code); });
  if (!entries) return tl::unexpected(entries.error());
  auto match = best_match(*entries, identity);
  if (match) return std::move(*match);
  return fail(ErrorCode::kUnknownDevice, to_string(identity),
              because("none of the {count} devices in the ESI files has this vendor and product", device_count()));
}

Result<const DeviceDescription*> EsiCatalogue::device(const CatalogueEntry& entry) const {
  const auto file = state_->file(entry.file);
  if (!file) return tl::unexpected(file.error());
  for (const auto& device : (*file)->devices) {
    Identity identity = device.identity;
    identity.serial_no = 0;
    if (identity == entry.identity && device.type == entry.type) return &device;
  }
  // The index takes a device by its first lines; the reader may have left it out because of a later one.
  const Error* reason = nullptr;
  for (const auto& error : (*file)->rejected) {
    if (error.line >= entry.line && (reason == nullptr || error.line < reason->line)) reason = &error;
  }
  if (reason != nullptr) return fail(*reason);
  return fail(ErrorCode::kUnknownDevice, to_string(entry.identity), because("{file} has it no longer", entry.file));
}

Result<DeviceMatch> EsiCatalogue::device_for(const Identity& identity) const {
  auto found = match(identity);
  if (!found) return tl::unexpected(found.error());
  const auto description = device(found->entry);
  if (!description) return tl::unexpected(description.error());
  return DeviceMatch{*description, found->kind == MatchKind::kExact, found->kind, std::move(found->words)};
}

std::optional<DeviceMatch> EsiCatalogue::find(const Identity& identity) const {
  auto found = device_for(identity);
  return found ? std::optional(std::move(*found)) : std::nullopt;
}

}  // namespace syncline::eni
