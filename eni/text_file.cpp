// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "eni/xml_limits.h"
#include "eni/xml_text.h"

namespace syncline::eni {
namespace {

tl::unexpected<Error> file_error(ErrorCode code, const std::string& path, int number) {
  return fail(Error{.code = code, .detail = std::strerror(number), .file = path});
}

constexpr std::size_t kPipeChunk = 1U << 16;

tl::unexpected<Error> too_long(const std::string& path) {
  return fail(Error{.code = ErrorCode::kFileLimit, .detail = fmt::format("it has more than {} MB", kMaxFileBytes >> 20), .file = path});
}

struct OpenFile {
  explicit OpenFile(const std::string& path) : descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor;
};

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
  const OpenFile file(path);
  struct stat status{};
  if (file.descriptor < 0 || ::fstat(file.descriptor, &status) != 0) {
    return file_error(errno == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable, path, errno);
  }
  if (S_ISDIR(status.st_mode)) return file_error(ErrorCode::kFileNotReadable, path, EISDIR);
  if (S_ISREG(status.st_mode) && static_cast<std::uintmax_t>(status.st_size) > kMaxFileBytes) return too_long(path);
  // One more than it has: the end is then seen at once. What is no ordinary file (a pipe) has no size.
  std::string content(S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : kPipeChunk, '\0');
  std::size_t size = 0;
  for (;;) {
    const auto count = ::read(file.descriptor, content.data() + size, content.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return file_error(ErrorCode::kFileNotReadable, path, errno);
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
    if (size > kMaxFileBytes) return too_long(path);
    if (size == content.size()) content.resize(2 * size);
  }
  content.resize(size);
  return content;
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
