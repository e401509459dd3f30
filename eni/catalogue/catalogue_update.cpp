// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/catalogue_update.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <string_view>

#include "eni/catalogue/catalogue_store.h"
#include "eni/catalogue/content_hash.h"
#include "eni/catalogue/esi_cards.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "support/input_file.h"
#include "support/paths_in.h"

namespace syncline::eni {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFilesPerTransaction = 200;  // what a killed program loses at most
constexpr std::int64_t kNsPerSecond = 1'000'000'000;

struct FoundFile {
  std::string path;
  std::int64_t size = 0, changed_ns = IndexedFile::kUncertain;
};

bool has_xml_name(const fs::path& path) {
  const auto extension = path.extension().string();
  constexpr std::string_view kWanted = ".xml";
  return std::ranges::equal(extension, kWanted,
                            [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

FoundFile look_at(const std::string& path) {
  FoundFile found{path};
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return found;
  found.size = status.st_size;
  found.changed_ns = status.st_mtim.tv_sec * kNsPerSecond + status.st_mtim.tv_nsec;
  return found;
}

/// A file that was written just now may be written again within the same tick of the file system's clock, with the same
/// size: it is looked into once more next time.
std::int64_t certain_time(const FoundFile& file) {
  constexpr std::int64_t kTick = 2 * kNsPerSecond;
  const auto now =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
  return now - file.changed_ns < kTick ? IndexedFile::kUncertain : file.changed_ns;
}

struct FoundFiles {
  std::vector<FoundFile> files;
  std::vector<std::string> unreadable;  // folders below
};

/// Folders below that cannot be read are named; links to folders are not followed, they may lead round in circles.
std::error_code list_below(const fs::path& folder, FoundFiles& found) {
  std::error_code error;
  for (const auto& path : paths_in(folder, error)) {
    std::error_code none;
    if (fs::is_directory(path, none)) {
      if (!fs::is_symlink(path, none) && list_below(path, found)) found.unreadable.push_back(path.string());
    } else if (has_xml_name(path) && !is_stream(path.string())) {
      found.files.push_back(look_at(path.string()));
    }
  }
  return error;
}

Result<FoundFiles> list_files(const std::string& folder) {
  FoundFiles found;
  if (const auto error = list_below(folder, found)) {
    const bool missing = error == std::errc::no_such_file_or_directory;
    return fail(Error{.code = missing ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable,
                      .detail = Reason::phrase(error.message()),
                      .file = folder});
  }
  std::ranges::sort(found.files, {}, &FoundFile::path);  // the same folder gives the same catalogue on every machine
  std::ranges::sort(found.unreadable);
  return found;
}

/// An error of the file for whoever asked; the store's own errors always fail.
struct Outcome {
  std::int64_t id = 0;
  bool changed = false;
  std::optional<Error> problem;
};

Result<Outcome> index_file(CatalogueStore& store, const FoundFile& file, const std::optional<IndexedFile>& known) {
  Outcome outcome;
  IndexedFile row{.size = file.size, .changed_ns = certain_time(file)};
  EsiCards cards;
  const auto text = read_file(file.path);
  if (text) {
    row.content = content_hash(*text);
    if (known && known->content == row.content && known->size == row.size) {
      if (auto status = store.touch(known->id, row.changed_ns); !status) return tl::unexpected(status.error());
      outcome.id = known->id;
      return outcome;
    }
    auto found = read_cards(*text, file.path);
    if (found) {
      cards = std::move(*found);
    } else {
      outcome.problem = found.error();
    }
  } else {
    outcome.problem = text.error();
    row.changed_ns = IndexedFile::kUncertain;  // permissions change without the file's time
  }
  if (outcome.problem) {
    const Error& problem = *outcome.problem;
    cards.warnings.push_back({file.path, problem.line, problem.subject, reason_of(problem)});
  }
  const auto id = store.put(file.path, row, cards);
  if (!id) return tl::unexpected(id.error());
  outcome.id = *id;
  outcome.changed = true;
  return outcome;
}

class FolderUpdate {
 public:
  FolderUpdate(CatalogueStore& store, const std::string& folder, const IndexCallback& callback)
      : store_(store), folder_(folder), callback_(callback) {}

  Result<IndexReport> run() {
    auto listed = list_files(folder_);
    if (!listed) return tl::unexpected(listed.error());
    const auto* const files = &listed->files;
    report_.unreadable = std::move(listed->unreadable);
    report_.files = files->size();
    auto known = store_.files_below(folder_);
    if (!known) return tl::unexpected(known.error());
    for (auto& [path, row] : *known) known_.emplace(std::move(path), row);
    split(*files);
    // Nothing to write, no lock to take.
    if (!changed_.empty() || !gone_.empty()) {
      if (auto status = write(); !status) return tl::unexpected(status.error());
    }
    if (auto status = choose(*files); !status) return tl::unexpected(status.error());
    return report_;
  }

 private:
  void split(const std::vector<FoundFile>& files) {
    for (const auto& file : files) {
      const auto found = known_.find(file.path);
      const bool same = found != known_.end() && found->second.size == file.size &&
                        found->second.changed_ns == file.changed_ns && file.changed_ns != IndexedFile::kUncertain;
      if (!same) changed_.push_back(&file);
    }
    const auto exists = [&](const std::string& path) {
      return std::ranges::binary_search(files, path, {}, &FoundFile::path);
    };
    for (const auto& [path, row] : known_) {
      if (!exists(path) && !is_out_of_sight(path)) gone_.push_back(row.id);
    }
  }

  /// Below a folder that cannot be read now: what is known of it stays.
  [[nodiscard]] bool is_out_of_sight(const std::string& path) const {
    return std::ranges::any_of(report_.unreadable, [&](const std::string& below) {
      return path.starts_with(below) && path.size() > below.size() &&
             path[below.size()] == fs::path::preferred_separator;
    });
  }

  /// In the order of the paths, whichever of them had to be read; those of before a cancelled reading too.
  Status choose(const std::vector<FoundFile>& files) {
    std::vector<std::string_view> paths;
    for (const auto& file : files) paths.push_back(file.path);
    for (const auto& [path, row] : known_) {
      if (is_out_of_sight(path)) paths.push_back(path);
    }
    std::ranges::sort(paths);
    if (auto status = store_.database().execute("SAVEPOINT choosing"); !status) return status;
    for (const auto path : paths) {
      const auto row = known_.find(path);
      if (row == known_.end()) continue;
      if (auto status = store_.choose(row->second.id); !status) return status;
    }
    return store_.database().execute("RELEASE choosing");
  }

  Status write() {
    for (std::size_t from = 0; from == 0 || (from < changed_.size() && !report_.cancelled);
         from += kFilesPerTransaction) {
      auto transaction = SqlTransaction::begin(store_.database());
      if (!transaction) return tl::unexpected(transaction.error());
      if (from == 0) {
        if (auto status = remove_gone(); !status) return status;
      }
      const auto to = std::min(from + kFilesPerTransaction, changed_.size());
      for (std::size_t i = from; i < to && !report_.cancelled; ++i) {
        if (auto status = write_file(i); !status) return status;
      }
      if (auto status = transaction->commit(); !status) return status;
    }
    return {};
  }

  Status remove_gone() {
    for (const auto id : gone_) {
      if (auto status = store_.remove(id); !status) return status;
    }
    report_.removed = gone_.size();
    return {};
  }

  Status write_file(std::size_t number) {
    const auto& file = *changed_[number];
    if (callback_ && !callback_({number, changed_.size(), file.path})) {
      report_.cancelled = true;
      return {};
    }
    const auto known = known_.find(file.path);
    const auto outcome = index_file(store_, file, known == known_.end() ? std::nullopt : std::optional(known->second));
    if (!outcome) return tl::unexpected(outcome.error());
    (outcome->changed ? report_.read : report_.touched) += 1;
    known_[file.path].id = outcome->id;
    return {};
  }

  CatalogueStore& store_;
  const std::string& folder_;
  const IndexCallback& callback_;
  IndexReport report_;
  std::map<std::string, IndexedFile, std::less<>> known_;
  std::vector<const FoundFile*> changed_;
  std::vector<std::int64_t> gone_;
};

}  // namespace

Result<IndexReport> update_folder(CatalogueStore& store, const std::string& folder, const IndexCallback& callback) {
  return FolderUpdate(store, folder, callback).run();
}

Status update_file(CatalogueStore& store, const std::string& path) {
  auto transaction = SqlTransaction::begin(store.database());
  if (!transaction) return tl::unexpected(transaction.error());
  const auto outcome = index_file(store, look_at(path), std::nullopt);
  if (!outcome) return tl::unexpected(outcome.error());
  if (outcome->problem) return tl::unexpected(*outcome->problem);  // nothing of it is kept
  if (auto status = store.choose(outcome->id); !status) return status;
  return transaction->commit();
}

}  // namespace syncline::eni
