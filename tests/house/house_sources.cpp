// SPDX-License-Identifier: Apache-2.0
#include "tests/house/house_sources.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/support/source_dir.h"

namespace syncline::test::house {

namespace fs = std::filesystem;

std::vector<std::string> sources(const std::string& folder) {
  const fs::path root = source_dir();
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") found.push_back(fs::relative(entry.path(), root).generic_string());
  }
  std::ranges::sort(found);
  return found;
}

std::vector<std::string> folders_of(const std::string& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(fs::path(source_dir()) / folder)) {
    if (entry.is_directory()) found.push_back(folder + "/" + entry.path().filename().string());
  }
  std::ranges::sort(found);
  return found;
}

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(fs::path(source_dir()) / file).rdbuf();
  return text.str();
}

std::vector<Include> includes_of(const std::string& file) {
  static const std::regex pattern(R"re(#include ([<"])([^>"]+)[>"])re");
  const auto text = text_of(file);
  std::vector<Include> found;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    found.push_back({(*it)[2], (*it)[1] == "\""});
  return found;
}

std::string file_of(const std::string& include) {
  for (const auto& candidate : {"core/" + include, include, "tests/" + include}) {
    if (fs::exists(fs::path(source_dir()) / candidate)) return candidate;
  }
  return {};
}

}  // namespace syncline::test::house
