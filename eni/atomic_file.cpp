// SPDX-License-Identifier: Apache-2.0
#include "eni/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

namespace syncline::eni {
namespace {

tl::unexpected<Error> file_error(ErrorCode code, const std::string& path, int error) {
  return fail(Error{.code = code, .detail = std::strerror(error), .file = path});
}

bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      return false;
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// mkstemp makes files that only the owner reads; an export is an ordinary file.
mode_t ordinary_mode(const std::string& path) {
  struct stat existing{};
  if (::stat(path.c_str(), &existing) == 0) {
    return existing.st_mode & 07777;
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

Status write_file_atomically(const std::string& path, std::string_view content) {
  const std::string pattern = path + ".XXXXXX";
  std::vector<char> temporary(pattern.begin(), pattern.end());
  temporary.push_back('\0');
  const int file = ::mkstemp(temporary.data());
  if (file < 0) {
    return file_error(ErrorCode::kFileNotWritable, path, errno);
  }
  bool done = write_all(file, content) && ::fchmod(file, ordinary_mode(path)) == 0 && ::fsync(file) == 0;
  int error = errno;
  if (::close(file) != 0 && done) {
    done = false;
    error = errno;
  }
  if (done && std::rename(temporary.data(), path.c_str()) != 0) {
    done = false;
    error = errno;
  }
  if (!done) {
    ::unlink(temporary.data());
    return file_error(ErrorCode::kFileNotWritable, path, error);
  }
  return {};
}

Result<std::string> read_whole_file(const std::string& path) {
  struct stat info{};
  if (::stat(path.c_str(), &info) != 0) {
    return file_error(errno == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable, path, errno);
  }
  if (S_ISDIR(info.st_mode)) {
    return file_error(ErrorCode::kFileNotReadable, path, EISDIR);
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    return file_error(ErrorCode::kFileNotReadable, path, errno);
  }
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

}  // namespace syncline::eni
