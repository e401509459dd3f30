// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

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

/// What a file is written to before it gets its name. While its descriptor is open it is locked: another program that cleans
/// up knows that somebody is at work.
class TemporaryFile {
 public:
  static std::optional<TemporaryFile> beside(const std::string& target) {
    for (;;) {
      TemporaryFile file;
      file.name_ = temporary_prefix(target) + "XXXXXX";
      file.descriptor_ = ::mkstemp(file.name_.data());
      if (file.descriptor_ < 0) return std::nullopt;
      struct stat status{};
      // Somebody may have cleaned it up before it was locked.
      if (::flock(file.descriptor_, LOCK_EX) != 0 || ::fstat(file.descriptor_, &status) != 0 || status.st_nlink > 0) return file;
    }
  }

  /// Hidden, and no name that a user would give: "folder/.name.saving-" and six characters.
  static std::string temporary_prefix(const std::string& target) {
    constexpr std::size_t kLongest = 200;  // names of 255 bytes are the most that file systems take
    const std::filesystem::path file(target);
    return (file.parent_path() / ("." + file.filename().string().substr(0, kLongest) + ".saving-")).string();
  }

  TemporaryFile(TemporaryFile&& other) noexcept
      : name_(std::move(other.name_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  bool fill(std::string_view content, mode_t mode) const { return ::fchmod(descriptor_, mode) == 0 && write_all(descriptor_, content); }
  bool rename_to(const std::string& target) const { return std::rename(name_.c_str(), target.c_str()) == 0; }
  void remove() const { ::unlink(name_.c_str()); }

 private:
  TemporaryFile() = default;
  std::string name_;
  int descriptor_ = -1;
};

/// Temporary files of programs that were killed while they saved `target`.
void remove_left_overs(const std::string& target) {
  constexpr std::size_t kRandomCharacters = 6;
  const auto prefix = std::filesystem::path(TemporaryFile::temporary_prefix(target)).filename().string();
  const auto folder = std::filesystem::path(target).parent_path();
  std::error_code error;
  std::vector<std::string> found;
  for (std::filesystem::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end; it.increment(error)) {
    const auto name = it->path().filename().string();
    if (name.size() == prefix.size() + kRandomCharacters && name.starts_with(prefix)) found.push_back(it->path().string());
  }
  for (const auto& name : found) {
    const OpenFile file(name);
    if (file.descriptor >= 0 && ::flock(file.descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(name.c_str());
  }
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
  remove_left_overs(target);
  auto temporary = TemporaryFile::beside(target);
  if (!temporary) return file_error(ErrorCode::kFileNotWritable, path, errno);
  if (!temporary->fill(content, ordinary_mode(target)) || !temporary->rename_to(target)) {
    const int number = errno;
    temporary->remove();
    return file_error(ErrorCode::kFileNotWritable, path, number);
  }
  sync_folder(std::filesystem::path(target).parent_path());
  return {};
}

}  // namespace syncline::eni
