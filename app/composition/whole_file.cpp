// SPDX-License-Identifier: Apache-2.0
#include "app/composition/whole_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace syncline {

Result<std::vector<std::uint8_t>> read_whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail({.code = ErrorCode::kFileNotFound, .file = path});
  const std::vector<char> text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return fail({.code = ErrorCode::kFileNotReadable, .file = path});
  return std::vector<std::uint8_t>(text.begin(), text.end());
}

Status write_whole_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  const auto part = path + ".part";
  {
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) return fail({.code = ErrorCode::kFileNotWritable, .file = path});
  }
  std::error_code error;
  std::filesystem::rename(part, path, error);
  if (error) return fail({.code = ErrorCode::kFileNotWritable, .detail = error.message(), .file = path});
  return {};
}

}  // namespace syncline
