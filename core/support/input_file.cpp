// SPDX-License-Identifier: Apache-2.0
#include "support/input_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "reasons/because.h"
#include "support/stop_signals.h"

namespace syncline {
namespace {

tl::unexpected<Error> input_error(const std::string& path, int number) {
  const auto code = number == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable;
  return fail(Error{.code = code, .detail = Reason::of_system(number), .file = path});
}

}  // namespace

Result<InputFile> InputFile::open(const std::string& path) {
  // Not blocking: a pipe without a writer is waited for where signals are heard.
  InputFile file(path, ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  struct stat status {};
  if (file.descriptor_ < 0 || ::fstat(file.descriptor_, &status) != 0) return input_error(path, errno);
  if (S_ISDIR(status.st_mode)) return input_error(path, EISDIR);
  file.ordinary_ = S_ISREG(status.st_mode);
  if (file.ordinary_) file.size_ = static_cast<std::size_t>(status.st_size);
  if (!file.ordinary_ && StopSignals::current() < 0) file.own_ = std::make_unique<StopSignals>();
  return file;
}

InputFile::InputFile(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)),
      own_(std::move(other.own_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      ordinary_(other.ordinary_),
      size_(other.size_) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status InputFile::wait() {
  if (ordinary_) return {};
  std::array<pollfd, 2> both{pollfd{descriptor_, POLLIN, 0}, pollfd{StopSignals::current(), POLLIN, 0}};
  for (;;) {
    if (::poll(both.data(), both.size(), -1) < 0 && errno != EINTR) return input_error(path_, errno);
    if ((both[1].revents & POLLIN) != 0)
      return fail(Error{.code = ErrorCode::kCancelled,
                        .detail = because("a signal ended the waiting for its content"),
                        .file = path_});
    if (both[0].revents != 0) return {};
  }
}

Result<std::size_t> InputFile::read(std::span<char> room) {
  for (;;) {
    if (auto status = wait(); !status) return tl::unexpected(status.error());
    const auto count = ::read(descriptor_, room.data(), room.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EAGAIN && errno != EINTR) return input_error(path_, errno);
  }
}

int InputFile::release() {
  const int flags = ::fcntl(descriptor_, F_GETFL);
  if (flags >= 0) (void)::fcntl(descriptor_, F_SETFL, flags & ~O_NONBLOCK);
  return std::exchange(descriptor_, -1);
}

bool is_stream(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace syncline
