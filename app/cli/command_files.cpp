// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/composition/link_files.h"
#include "sqlite/database_files.h"
#include "support/paths_in.h"

namespace syncline::cli {
namespace {

namespace fs = std::filesystem;

std::string name_of(std::string_view option) {
  // Options begin with a dash, what has no name of its own is a phrase already.
  const bool argument = !option.starts_with('-') && option.find(' ') == std::string_view::npos;
  return argument ? fmt::format("the argument {}", option) : std::string(option);
}

void add(std::vector<NamedFile>& files, std::string_view option, const std::string& path) {
  if (!path.empty()) files.push_back({name_of(option), path});
}

/// With the folders below; links are not followed, and what cannot be read has no files.
void add_esi_files(std::vector<NamedFile>& files, const std::string& what, const fs::path& folder) {
  std::error_code error;
  for (const auto& path : paths_in(folder, error)) {
    std::error_code none;
    const auto extension = path.extension();
    if (fs::is_directory(fs::symlink_status(path, none))) {
      add_esi_files(files, what, path);
    } else if (extension == ".xml" || extension == ".XML") {
      files.push_back({what, path.string()});
    }
  }
}

std::vector<std::string> files_of(const std::string& database) {
  return database.empty() ? std::vector<std::string>{} : database_files(database);
}

}  // namespace

CommandFiles& CommandFiles::reads(std::string_view option, const std::string& path) {
  add(read_, option, path);
  return *this;
}

CommandFiles& CommandFiles::reads_recording(std::string_view option, const std::string& path) {
  for (const auto& file : files_of(path)) add(read_, option, file);
  return *this;
}

CommandFiles& CommandFiles::reads_link(std::string_view option, const std::string& link) {
  add(links_, option, link);
  return *this;
}

CommandFiles& CommandFiles::reads_esi(std::string_view option, const std::string& folder) {
  add(folders_, option, folder);
  return *this;
}

CommandFiles& CommandFiles::writes(std::string_view option, const std::string& path) {
  add(written_, option, path);
  return *this;
}

CommandFiles& CommandFiles::writes_database(std::string_view option, const std::string& path) {
  for (const auto& file : files_of(path)) add(written_, option, file);
  return *this;
}

Status CommandFiles::check() const {
  auto read = read_;
  // What is not there yet is read by nobody: a scenario or a folder is looked through only where something may be lost.
  const bool may_lose = std::ranges::any_of(written_, [](const NamedFile& file) {
    std::error_code error;
    return fs::is_regular_file(file.path, error);
  });
  if (may_lose) {
    for (const auto& link : links_) {
      auto files = link_files(link.path);
      if (!files) return tl::unexpected(files.error());
      for (auto& file : *files) read.push_back({link.what, std::move(file)});
    }
    for (const auto& folder : folders_) add_esi_files(read, folder.what, folder.path);
  }
  return check_distinct(read, written_);
}

}  // namespace syncline::cli
