// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "eni/xml_text.h"

namespace syncline::eni {
namespace {

tl::unexpected<Error> file_error(ErrorCode code, const std::string& path, int number) {
  return fail(Error{.code = code, .detail = std::strerror(number), .file = path});
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const auto written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(descriptor) == 0;
}

/// The rename is on the disk only when its folder is.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);
  ::close(descriptor);
}

/// mkstemp makes files that only the owner reads; a saved file is an ordinary one, a replaced one keeps its permissions.
mode_t ordinary_mode(const std::string& target) {
  struct stat status{};
  if (::stat(target.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// Through a symbolic link the file that it names is replaced, not the link.
std::string link_target(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const auto target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  struct stat status{};
  if (::stat(path.c_str(), &status) != 0) {
    return file_error(errno == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable, path, errno);
  }
  if (S_ISDIR(status.st_mode)) return file_error(ErrorCode::kFileNotReadable, path, EISDIR);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return file_error(ErrorCode::kFileNotReadable, path, errno);
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) return file_error(ErrorCode::kFileNotReadable, path, EIO);
  return std::move(content).str();
}

Status write_file_atomic(const std::string& path, std::string_view content) {
  const std::string target = link_target(path);
  std::string temporary = target + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) return file_error(ErrorCode::kFileNotWritable, path, errno);
  bool ok = ::fchmod(descriptor, ordinary_mode(target)) == 0 && write_all(descriptor, content);
  int number = errno;
  if (::close(descriptor) != 0 && ok) {
    ok = false;
    number = errno;
  }
  if (ok && std::rename(temporary.c_str(), target.c_str()) != 0) {
    ok = false;
    number = errno;
  }
  if (!ok) {
    ::unlink(temporary.c_str());
    return file_error(ErrorCode::kFileNotWritable, path, number);
  }
  sync_folder(std::filesystem::path(target).parent_path());
  return {};
}

}  // namespace syncline::eni
