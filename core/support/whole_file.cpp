// SPDX-License-Identifier: Apache-2.0
#include "support/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "reasons/because.h"
#include "support/output_file.h"

namespace syncline {
namespace {

constexpr std::size_t kPipeChunk = 1U << 16;

struct InputFile {
  explicit InputFile(const std::string& path) : descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {}
  ~InputFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  int descriptor;
};

tl::unexpected<Error> not_readable(const std::string& path, int number) {
  if (number == EINTR) return fail(Error{.code = ErrorCode::kCancelled, .file = path});
  const auto code = number == ENOENT ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable;
  return fail(Error{.code = code, .detail = Reason::of_system(number), .file = path});
}

tl::unexpected<Error> too_long(const std::string& path, std::size_t largest) {
  return fail(Error{
      .code = ErrorCode::kFileLimit, .detail = because("it has more than {limit} MB", largest >> 20), .file = path});
}

}  // namespace

Result<std::string> read_whole_file(const std::string& path, std::size_t largest) {
  const InputFile file(path);
  struct stat status {};
  if (file.descriptor < 0 || ::fstat(file.descriptor, &status) != 0) return not_readable(path, errno);
  if (S_ISDIR(status.st_mode)) return not_readable(path, EISDIR);
  const bool ordinary = S_ISREG(status.st_mode);
  if (ordinary && static_cast<std::uintmax_t>(status.st_size) > largest) return too_long(path, largest);
  // One more than it has: the end is then seen at once. What is no ordinary file (a pipe) has no size.
  std::string content(ordinary ? static_cast<std::size_t>(status.st_size) + 1 : kPipeChunk, '\0');
  std::size_t size = 0;
  for (;;) {
    const auto count = ::read(file.descriptor, content.data() + size, content.size() - size);
    if (count < 0) return not_readable(path, errno);
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
    if (size > largest) return too_long(path, largest);
    if (size == content.size()) content.resize(2 * size);
  }
  content.resize(size);
  return content;
}

Status write_whole_file(const std::string& path, std::string_view content) {
  auto file = OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto status = file->write(content); !status) return status;
  return file->finish();
}

Status write_whole_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  return write_whole_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace syncline
