// SPDX-License-Identifier: Apache-2.0
#include "support/shared_epoch.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace syncline {
namespace {

constexpr const char* kFile = "/dev/shm/syncline-epoch";
constexpr std::uint64_t kMagic = 0x3130'6863'6F70'6544ULL;
constexpr int kEpochTries = 32;
constexpr int kPatience = 100;  // times a millisecond, for another program that is just writing
constexpr mode_t kEverybody = 0666;

Nanoseconds reading_of(clockid_t id) {
  timespec time{};
  ::clock_gettime(id, &time);
  return static_cast<Nanoseconds>(time.tv_sec) * kSecond + time.tv_nsec;
}

/// Not with O_CREAT where it is there: in folders that everybody may write, systems refuse that for files of others.
int open_file(const std::string& path) {
  int fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0) fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kEverybody);
  if (fd < 0) fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);  // another program was faster
  if (fd >= 0) (void)::fchmod(fd, kEverybody);                             // against the umask; only its owner can
  return fd;
}

struct Content {
  std::uint64_t magic = kMagic;
  std::int64_t shift = 0;
};

std::optional<Nanoseconds> read_shift(int fd) {
  Content content;
  if (::pread(fd, &content, sizeof(content), 0) != sizeof(content) || content.magic != kMagic) return std::nullopt;
  return content.shift;
}

bool write_shift(int fd, Nanoseconds shift) {
  const Content content{kMagic, shift};
  return ::pwrite(fd, &content, sizeof(content), 0) == sizeof(content);
}

bool lock_within_patience(int fd) {
  for (int i = 0; i < kPatience; ++i) {
    if (::flock(fd, LOCK_SH | LOCK_NB) == 0) return true;
    ::usleep(1'000);
  }
  return false;
}

}  // namespace

Nanoseconds calendar_shift() {
  auto shortest = std::numeric_limits<Nanoseconds>::max();
  Nanoseconds shift = 0;
  for (int i = 0; i < kEpochTries; ++i) {
    const auto before = reading_of(CLOCK_MONOTONIC), calendar = reading_of(CLOCK_REALTIME),
               after = reading_of(CLOCK_MONOTONIC);
    if (after - before >= shortest) continue;
    shortest = after - before;
    shift = calendar - (before + (after - before) / 2);
  }
  return shift - kDcEpochUnixSeconds * kSecond;
}

const SharedEpoch& SharedEpoch::of_this_machine() {
  static const SharedEpoch epoch(kFile);
  return epoch;
}

SharedEpoch::SharedEpoch(const std::string& path, const std::function<Nanoseconds()>& calendar) : fd_(open_file(path)) {
  if (fd_ >= 0 && take_part(calendar)) return;
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
  shift_ = calendar();
}

/// Who can lock the file for itself is alone, and says the shift anew. Everybody reads it under a lock that is shared
/// with the others and held to the end.
bool SharedEpoch::take_part(const std::function<Nanoseconds()>& calendar) {
  if (::flock(fd_, LOCK_EX | LOCK_NB) == 0 && !write_shift(fd_, calendar())) return false;
  if (!lock_within_patience(fd_)) return false;
  const auto shift = read_shift(fd_);
  if (shift) shift_ = *shift;
  return shift.has_value();
}

SharedEpoch::~SharedEpoch() {
  if (fd_ >= 0) ::close(fd_);  // and the lock with it
}

}  // namespace syncline
