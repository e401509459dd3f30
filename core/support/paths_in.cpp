// SPDX-License-Identifier: Apache-2.0
#include "support/paths_in.h"

#include <dirent.h>

#include <cerrno>
#include <memory>
#include <string_view>

namespace syncline {
namespace {

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

}  // namespace

std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder, std::error_code& error) {
  error.clear();
  std::vector<std::filesystem::path> found;
  const std::unique_ptr<DIR, CloseFolder> open(::opendir(folder.c_str()));
  if (open == nullptr) {
    error.assign(errno, std::generic_category());
    return found;
  }
  for (;;) {
    errno = 0;  // the end is told as an error is
    const dirent* entry = ::readdir(open.get());
    if (entry == nullptr) break;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") found.push_back(folder / name);
  }
  if (errno != 0) error.assign(errno, std::generic_category());
  return found;
}

}  // namespace syncline
