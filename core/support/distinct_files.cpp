// SPDX-License-Identifier: Apache-2.0
#include "support/distinct_files.h"

#include <sys/stat.h>

#include <filesystem>

#include "reasons/because.h"
#include "support/followed_path.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> not_distinct(const NamedFile& written, Reason why) {
  return fail(ErrorCode::kBadValue, written.what, std::move(why));
}

}  // namespace

bool is_same_file(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  const auto a = follow_links(one), b = follow_links(other);
  if (a.in_proc || b.in_proc) return false;
  struct stat of_a {
  }, of_b{};
  const bool a_there = ::stat(a.file.c_str(), &of_a) == 0, b_there = ::stat(b.file.c_str(), &of_b) == 0;
  if (a_there != b_there) return false;
  if (a_there) return S_ISREG(of_a.st_mode) && of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
  // In a folder that is not there nothing can be written.
  std::error_code error;
  return fs::path(a.file).filename() == fs::path(b.file).filename() &&
         fs::equivalent(folder_of(a.file), folder_of(b.file), error) && !error;
}

Status check_distinct(std::span<const NamedFile> read, std::span<const NamedFile> written) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    for (const auto& input : read) {
      if (is_same_file(written[i].path, input.path)) {
        return not_distinct(written[i], because("{file} is what {what} reads and would be lost; name another file",
                                                written[i].path, input.what));
      }
    }
    for (const auto& other : written.first(i)) {
      if (is_same_file(written[i].path, other.path)) {
        return not_distinct(written[i], because("{what} writes the file {file}, too; name another one for one of them",
                                                other.what, written[i].path));
      }
    }
  }
  return {};
}

}  // namespace syncline
