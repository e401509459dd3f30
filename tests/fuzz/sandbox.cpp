// SPDX-License-Identifier: Apache-2.0
#include "fuzz/sandbox.h"

#include <cstdlib>
#include <fstream>

#include "support/whole_file.h"

namespace syncline::fuzz {

namespace fs = std::filesystem;

Sandbox::Sandbox() {
  std::error_code none;
  const auto base = fs::is_directory("/dev/shm", none) ? fs::path("/dev/shm") : fs::temp_directory_path();
  auto pattern = (base / "syncline-fuzz-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) std::abort();
  path_ = pattern;
}

Sandbox::~Sandbox() {
  std::error_code none;
  fs::remove_all(path_, none);
}

void Sandbox::put(const std::string& name, std::string_view content) const {
  const auto place = path_ / name;
  fs::create_directories(place.parent_path());
  std::ofstream(place, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

std::string Sandbox::text(const std::string& name) const { return read_whole_file(file(name)).value_or(""); }

void Sandbox::clear() const {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(path_, none)) fs::remove_all(entry.path(), none);
}

}  // namespace syncline::fuzz
