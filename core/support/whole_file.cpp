// SPDX-License-Identifier: Apache-2.0
#include "support/whole_file.h"

#include "reasons/because.h"
#include "support/input_file.h"
#include "support/output_file.h"

namespace syncline {
namespace {

constexpr std::size_t kPipeChunk = 1U << 16;

tl::unexpected<Error> too_long(const std::string& path, std::size_t largest) {
  return fail(Error{
      .code = ErrorCode::kFileLimit, .detail = because("it has more than {limit} MB", largest >> 20), .file = path});
}

}  // namespace

Result<std::string> read_whole_file(const std::string& path, std::size_t largest) {
  auto file = InputFile::open(path);
  if (!file) return tl::unexpected(file.error());
  if (file->size() > largest) return too_long(path, largest);
  // One more than it has: the end is then seen at once. What is no ordinary file (a pipe) has no size.
  std::string content(file->ordinary() ? file->size() + 1 : kPipeChunk, '\0');
  std::size_t size = 0;
  for (;;) {
    const auto count = file->read(std::span(content).subspan(size));
    if (!count) return tl::unexpected(count.error());
    if (*count == 0) break;
    size += *count;
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
