// SPDX-License-Identifier: Apache-2.0
#include "support/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "reasons/because.h"
#include "support/attempt.h"
#include "support/followed_path.h"
#include "support/paths_in.h"
#include "support/stop_signals.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kGathered = 1U << 16;
constexpr std::size_t kRandomCharacters = 6;  // mkstemp's
constexpr mode_t kPermissions = 07777;

/// Hidden, and no name that a user would give: "folder/.name.saving-" and six characters.
std::string temporary_prefix(const std::string& target) {
  constexpr std::size_t kLongest = 200;  // names of 255 bytes are the most that file systems take
  const fs::path file(target);
  return (file.parent_path() / ("." + file.filename().string().substr(0, kLongest) + ".saving-")).string();
}

/// Temporary files of programs that were killed while they wrote `target`. Those of programs at work are locked.
void remove_left_overs(const std::string& target) {
  const auto prefix = fs::path(temporary_prefix(target)).filename().string();
  std::error_code error;
  std::vector<std::string> found;
  for (const auto& path : paths_in(folder_of(target), error)) {
    const auto name = path.filename().string();
    if (name.size() == prefix.size() + kRandomCharacters && name.starts_with(prefix)) found.push_back(path.string());
  }
  for (const auto& name : found) {
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    struct stat status {};
    const bool ordinary = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    if (ordinary && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(name.c_str());
    ::close(descriptor);
  }
}

/// mkstemp makes files that only the owner reads; a new file is an ordinary one, a replaced one stays whose and what it
/// was.
bool take_over_permissions(int descriptor, const std::string& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) != 0) {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return ::fchmod(descriptor, 0666 & ~mask) == 0;
  }
  const bool same_owner = ::fchown(descriptor, old.st_uid, old.st_gid) == 0;
  return ::fchmod(descriptor, old.st_mode & (same_owner ? kPermissions : 0777U)) == 0;
}

/// The rename is on the disk only when its folder is.
void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);
  ::close(descriptor);
}

/// errno of what ended the writing, 0 when all is written.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) return errno;
    if (written == 0) return EIO;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

Error not_writable(const std::string& path, Reason why) {
  return Error{.code = ErrorCode::kFileNotWritable, .detail = std::move(why), .file = path};
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::string& path) {
  OutputFile file;
  file.path_ = path;
  // Through symbolic links the file that they name is replaced, not the link.
  const auto target = follow_links(path);
  file.target_ = target.file;
  struct stat found {};
  const bool there = ::stat(file.target_.c_str(), &found) == 0;
  if (!there && errno != ENOENT) return fail(not_writable(path, Reason::of_system(errno)));
  if (there && S_ISDIR(found.st_mode)) return fail(not_writable(path, because("it is a folder")));
  if (there && S_ISBLK(found.st_mode)) return fail(not_writable(path, because("it is a disk, not a file")));
  if (there && S_ISSOCK(found.st_mode)) return fail(not_writable(path, because("it is a socket, not a file")));
  const bool in_place = there && (target.in_proc || !S_ISREG(found.st_mode));
  if (auto status = in_place ? file.open_in_place() : file.open_temporary(); !status)
    return tl::unexpected(status.error());
  return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      buffer_(std::move(other.buffer_)),
      status_(std::move(other.status_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  if (temporary_.empty() && status_) attempt([this] { return flush(); });
  discard();
}

Status OutputFile::open_in_place() {
  // A pipe without a reader is waited for.
  std::optional<StopSignals> own;
  if (StopSignals::current() < 0) own.emplace();
  descriptor_ = ::open(target_.c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC);
  return descriptor_ < 0 ? failed(errno) : Status{};
}

Status OutputFile::open_temporary() {
  remove_left_overs(target_);
  for (;;) {
    temporary_ = temporary_prefix(target_) + std::string(kRandomCharacters, 'X');
    descriptor_ = ::mkostemp(temporary_.data(), O_CLOEXEC);
    if (descriptor_ < 0) return failed(errno);
    struct stat status {};
    // Somebody may have cleaned it up before it was locked.
    if (::flock(descriptor_, LOCK_EX) != 0 || ::fstat(descriptor_, &status) != 0 || status.st_nlink > 0) return {};
    ::close(std::exchange(descriptor_, -1));
  }
}

Status OutputFile::write(std::string_view bytes) {
  if (!status_) return status_;
  buffer_.append(bytes);
  return buffer_.size() < kGathered ? Status{} : flush();
}

Status OutputFile::flush() {
  if (!status_) return status_;
  const int number = write_all(descriptor_, buffer_);
  buffer_.clear();
  return number == 0 ? Status{} : failed(number);
}

Status OutputFile::finish() {
  if (auto status = flush(); !status) return status;
  if (temporary_.empty()) {
    if (::close(std::exchange(descriptor_, -1)) != 0) return failed(errno);
    return {};
  }
  if (!take_over_permissions(descriptor_, target_) || ::fsync(descriptor_) != 0) return failed(errno);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) return failed(errno);
  temporary_.clear();
  if (::close(std::exchange(descriptor_, -1)) != 0) return failed(errno);
  sync_folder(folder_of(target_));
  return {};
}

Status OutputFile::failed(int number) {
  if (number == EINTR) {
    status_ = fail(Error{
        .code = ErrorCode::kCancelled, .detail = because("a signal ended the waiting for its reader"), .file = path_});
  } else {
    status_ = fail(not_writable(path_, Reason::of_system(number)));
  }
  discard();
  return status_;
}

void OutputFile::discard() {
  if (descriptor_ < 0) return;
  // While it is locked: another program may take the name from then on.
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  ::close(std::exchange(descriptor_, -1));
  temporary_.clear();
  buffer_.clear();
}

}  // namespace syncline
