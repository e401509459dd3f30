// SPDX-License-Identifier: Apache-2.0
#include "sqlite/database_files.h"

#include <filesystem>
#include <system_error>

namespace syncline {

std::vector<std::string> database_files(const std::string& path) {
  return {path, path + "-wal", path + "-shm", path + "-journal"};
}

void remove_database(const std::string& path) {
  for (const auto& file : database_files(path)) {
    std::error_code error;
    std::filesystem::remove(file, error);
  }
}

std::uint64_t database_bytes(const std::string& path) {
  std::uint64_t bytes = 0;
  for (const auto& file : {path, path + "-wal"}) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (!error) bytes += size;
  }
  return bytes;
}

}  // namespace syncline
