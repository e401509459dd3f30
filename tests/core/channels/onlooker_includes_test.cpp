// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/source_dir.h"

/// Who looks at the master sees its channels and nothing behind them. The libraries cannot hold this alone: what links
/// a header's functions from somewhere else would build.
namespace syncline {
namespace {

struct Include {
  std::string file, header;
};

std::vector<Include> includes_below(const std::string& folder) {
  std::vector<Include> out;
  const std::filesystem::path root = test::source_dir();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    std::ifstream in(entry.path());
    constexpr std::string_view kBegin = "#include \"";
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with(kBegin)) continue;
      const auto end = line.find('"', kBegin.size());
      out.push_back({std::filesystem::relative(entry.path(), root).string(),
                     line.substr(kBegin.size(), end == std::string::npos ? end : end - kBegin.size())});
    }
  }
  return out;
}

bool is_of(const std::string& header, const std::vector<std::string>& rooms) {
  return std::ranges::any_of(rooms, [&](const std::string& room) { return header.starts_with(room + "/"); });
}

/// "FILE includes HEADER", a line each, of what comes from one of the rooms.
std::string forbidden(const std::string& folder, const std::vector<std::string>& rooms) {
  std::string out;
  const auto includes = includes_below(folder);
  EXPECT_FALSE(includes.empty()) << folder;
  for (const auto& include : includes) {
    if (is_of(include.header, rooms)) out += include.file + " includes " + include.header + "\n";
  }
  return out;
}

class Onlooker : public ::testing::TestWithParam<const char*> {};

TEST_P(Onlooker, SeesNeitherMasterNorLinkNorSimulator) {
  EXPECT_EQ(forbidden(GetParam(), {"master", "link", "sim", "app"}), "");
}
INSTANTIATE_TEST_SUITE_P(Rooms, Onlooker, ::testing::Values("ui", "eni", "core/trace", "core/diagnosis"),
                         [](const auto& room) {
                           std::string name = room.param;
                           std::ranges::replace(name, '/', '_');
                           return name;
                         });

TEST(Channels, SeeOnlyWhatCrossesThem) {
  std::string out;
  for (const auto& include : includes_below("core/channels")) {
    if (!is_of(include.header, {"channels", "config", "protocol", "support"})) {
      out += include.file + " includes " + include.header + "\n";
    }
  }
  EXPECT_EQ(out, "");
}

}  // namespace
}  // namespace syncline
