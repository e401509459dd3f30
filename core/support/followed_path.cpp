// SPDX-License-Identifier: Apache-2.0
#include "support/followed_path.h"

#include <linux/magic.h>
#include <sys/vfs.h>

#include <filesystem>
#include <utility>

namespace syncline {
namespace {

namespace fs = std::filesystem;

/// Its links name an open file of a program, which may have an ordinary file's contents.
bool in_proc(const std::string& file) {
  struct statfs status {};
  return ::statfs(folder_of(file).c_str(), &status) == 0 && status.f_type == PROC_SUPER_MAGIC;
}

}  // namespace

std::string folder_of(const std::string& file) {
  const auto folder = fs::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

FollowedPath follow_links(std::string file) {
  constexpr int kMostLinks = 40;  // as the kernel does
  for (int i = 0; i < kMostLinks; ++i) {
    if (in_proc(file)) return {std::move(file), true};
    std::error_code error;
    const auto next = fs::read_symlink(file, error);
    if (error) break;
    file = (fs::path(file).parent_path() / next).string();
  }
  return {std::move(file), false};  // stat() finds a loop
}

}  // namespace syncline
