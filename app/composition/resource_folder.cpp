// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>

#include "app/composition/open_link.h"

namespace syncline {

std::string resource_folder() {
  namespace fs = std::filesystem;
  if (const char* folder = std::getenv("SYNCLINE_RESOURCES"); folder != nullptr && *folder != '\0') return folder;
  std::error_code error;
  const auto binary = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto installed = binary.parent_path().parent_path() / "share" / "syncline";
    if (fs::is_directory(installed / "esi", error)) return installed.string();
  }
  return SYNCLINE_SOURCE_RESOURCES;
}

std::string demo_link(bool virtual_clock) {
  return "sim:" + resource_folder() + "/demo/machine.toml" + (virtual_clock ? "?virtual" : "");
}

}  // namespace syncline
