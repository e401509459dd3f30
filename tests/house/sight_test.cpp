// SPDX-License-Identifier: Apache-2.0
// What one has to see of the house to change something in it, held where it stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/house/house_sources.h"

namespace syncline {
namespace {

using namespace test::house;

/// How many headers of ours the longest chain of includes has that begins at a file.
class IncludeDepth {
 public:
  [[nodiscard]] int of(const std::string& file) {
    if (const auto known = known_.find(file); known != known_.end()) return known->second.depth;
    known_[file] = {};  // a circle adds nothing
    Chain longest;
    for (const auto& include : includes_of(file)) {
      const auto target = include.ours ? file_of(include.name) : std::string();
      if (target.empty()) continue;
      const int depth = of(target) + 1;
      if (depth > longest.depth) longest = {depth, target};
    }
    known_[file] = longest;
    return longest.depth;
  }
  [[nodiscard]] std::string chain(const std::string& file) const {
    std::string text = file;
    for (auto next = known_.at(file).next; !next.empty(); next = known_.at(next).next) text += " <- " + next;
    return text;
  }

 private:
  struct Chain {
    int depth = 0;
    std::string next;
  };
  std::map<std::string, Chain> known_;
};

struct DepthBound {
  const char* place;
  int median, most;
};

/// What a change of a header makes others compile anew, and what a reader has to know of: both grow with the chains of
/// includes. The bounds are what there is now; who gets below them lowers them.
TEST(House, ChainsOfIncludesGrowNoLonger) {
  constexpr DepthBound kBounds[] = {
      {"core", 5, 13},         {"core/advice", 6, 8},    {"core/capture", 4, 7}, {"core/channels", 4, 7},
      {"core/check", 6, 8},    {"core/compare", 5, 7},   {"core/compile", 7, 9}, {"core/config", 5, 6},
      {"core/dc", 2, 5},       {"core/diagnosis", 5, 6}, {"core/engine", 7, 8},  {"core/exports", 5, 6},
      {"core/families", 4, 4}, {"core/findings", 4, 5},  {"core/link", 4, 5},    {"core/master", 8, 13},
      {"core/protocol", 3, 5}, {"core/reasons", 4, 4},   {"core/record", 6, 8},  {"core/recover", 6, 8},
      {"core/reports", 7, 8},  {"core/settings", 6, 7},  {"core/sim", 5, 13},    {"core/sqlite", 3, 3},
      {"core/support", 2, 5},  {"core/trace", 4, 6},     {"eni", 5, 7},          {"ui", 6, 12},
      {"app", 6, 12}};
  IncludeDepth depth;
  for (const auto& bound : kBounds) {
    std::vector<std::pair<int, std::string>> depths;
    for (const auto& file : sources(bound.place)) {
      if (file.ends_with(".cpp")) depths.emplace_back(depth.of(file), file);
    }
    ASSERT_FALSE(depths.empty()) << bound.place;
    std::ranges::sort(depths);
    EXPECT_LE(depths[depths.size() / 2].first, bound.median) << "median of " << bound.place;
    EXPECT_LE(depths.back().first, bound.most) << depth.chain(depths.back().second);
  }
  for (const auto& folder : folders_of("core")) {
    EXPECT_TRUE(std::ranges::any_of(kBounds, [&](const DepthBound& bound) { return folder == bound.place; }))
        << folder << " has no bound";
  }
}

/// Those who build others of its parts, or lead slaves. All others get those parts that they need: who answers in which
/// state (SlaveStates), what is told (EventTeller), the snapshot, the mailboxes, the configuration.
TEST(House, FewSeeTheWholeRunState) {
  const std::vector<std::string> may{
      "core/master/cyclic/acyclic_scheduler.h", "core/master/cyclic/cyclic_task.h",
      "core/master/exchange/run_state.h",       "core/master/operation.h",
      "core/master/recovery/recovery.h",        "core/master/startup/attendance.h",
      "core/master/startup/clock_steps.h",      "core/master/startup/esm.h",
      "core/master/startup/slave_commands.h",
  };
  const std::regex whole("\\bRunState\\b");
  std::vector<std::string> see;
  for (const auto& file : sources("core")) {
    if (file.ends_with(".h") && std::regex_search(text_of(file), whole)) see.push_back(file);
  }
  EXPECT_EQ(see, may);
}

}  // namespace
}  // namespace syncline
