// SPDX-License-Identifier: Apache-2.0
// The rooms of the house as docs/architecture.md draws them, held against what the sources include.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/house/house_sources.h"
#include "tests/support/source_dir.h"

namespace syncline {
namespace {

using namespace test::house;

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// A room and the rooms that it may include; each also what is in itself.
struct Room {
  std::string folder;
  Names may;
};

const Names kValues{"core/reasons", "core/support", "core/protocol", "core/findings", "core/config"};

Names with(Names names, const Names& more) {
  names.insert(more.begin(), more.end());
  return names;
}

std::vector<Room> rooms() {
  const auto planned = with(kValues, {"core/families", "core/settings", "core/compile"});
  return {
      {"core/reasons", {}},
      {"core/support", {"core/reasons"}},
      {"core/protocol", {"core/reasons", "core/support"}},
      {"core/findings", {"core/reasons", "core/support", "core/protocol"}},
      {"core/sqlite", {"core/reasons", "core/support"}},
      {"core/config", {"core/reasons", "core/support", "core/protocol"}},
      {"core/families", kValues},
      {"core/settings", with(kValues, {"core/families"})},
      {"core/compile", with(kValues, {"core/families", "core/settings"})},
      {"core/check", planned},
      {"core/compare", with(kValues, {"core/families", "core/settings"})},
      {"core/recover", with(planned, {"core/compare"})},
      {"core/exports", kValues},
      {"core/advice", with(planned, {"core/check"})},
      {"core/channels", with(kValues, {"core/families"})},
      {"core/dc", with(kValues, {"core/channels"})},
      {"core/sim", with(kValues, {"core/families"})},
      {"core/link", with(kValues, {"core/sim"})},
      {"core/master",
       with(planned, {"core/dc", "core/channels", "core/link", "core/check", "core/compare", "core/recover"})},
      {"core/trace", with(kValues, {"core/dc", "core/channels"})},
      {"core/diagnosis", with(kValues, {"core/dc", "core/channels", "core/families", "core/findings", "core/trace"})},
      {"core/record",
       with(kValues, {"core/dc", "core/channels", "core/findings", "core/trace", "core/diagnosis", "core/sqlite"})},
      {"core/reports", with(kValues, {"core/channels", "core/trace", "core/record", "core/exports"})},
      {"core/capture", with(kValues, {"core/link", "core/findings", "core/trace", "core/record"})},
      {"core/engine", with(planned, {"core/channels", "core/compare", "core/sim", "core/link", "core/capture",
                                     "core/master", "core/trace", "core/record"})},
  };
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().generic_string(); }
/// "core/sim" of "core/sim/esc/esc.h", "eni" of "eni/xml/xml_text.h".
std::string room_of(const std::string& file) {
  const auto first = file.find('/');
  const auto place = file.substr(0, first);
  return place == "core" ? file.substr(0, file.find('/', first + 1)) : place;
}

class Graph {
 public:
  void add(const std::string& from, const std::string& to) {
    if (from != to) arrows_[from].insert(to);
  }
  /// The folders of a circle, in its order; empty when there is none.
  [[nodiscard]] std::vector<std::string> circle() const {
    Names done;
    for (const auto& [folder, targets] : arrows_) {
      std::vector<std::string> way;
      if (walk(folder, way, done)) return way;
    }
    return {};
  }

 private:
  bool walk(const std::string& folder, std::vector<std::string>& way, Names& done) const {
    if (const auto seen = std::ranges::find(way, folder); seen != way.end()) {
      way.erase(way.begin(), seen);
      return true;
    }
    if (done.contains(folder)) return false;
    way.push_back(folder);
    if (const auto found = arrows_.find(folder); found != arrows_.end()) {
      for (const auto& target : found->second) {
        if (walk(target, way, done)) return true;
      }
    }
    way.pop_back();
    done.insert(folder);
    return false;
  }
  std::map<std::string, Names> arrows_;
};

TEST(House, RoomsIncludeOnlyWhatStandsBelowThem) {
  const auto all = rooms();
  Names known;
  for (const auto& room : all) {
    for (const auto& below : room.may)
      EXPECT_TRUE(known.contains(below)) << room.folder << " stands in front of " << below;
    known.insert(room.folder);
    for (const auto& file : sources(room.folder)) {
      for (const auto& include : includes_of(file)) {
        if (!include.ours) continue;
        const auto target = file_of(include.name);
        ASSERT_FALSE(target.empty()) << file << " includes " << include.name;
        const auto other = room_of(target);
        EXPECT_TRUE(other == room.folder || room.may.contains(other)) << file << " includes " << target;
      }
    }
  }
  for (const auto& entry : fs::directory_iterator(fs::path(test::source_dir()) / "core")) {
    if (entry.is_directory()) {
      EXPECT_TRUE(known.contains("core/" + entry.path().filename().string())) << entry.path();
    }
  }
}

/// All rooms that a room may see, by way of others, too.
Names sees(const std::vector<Room>& all, const std::string& folder) {
  Names seen{folder};
  for (auto room = all.rbegin(); room != all.rend(); ++room) {  // each stands behind those that it may include
    if (seen.contains(room->folder)) seen.insert(room->may.begin(), room->may.end());
  }
  return seen;
}

/// Headers of the rooms that a test includes, itself or through what tests share.
Names included_rooms(const std::string& file, Names& done) {
  Names found;
  if (!done.insert(file).second) return found;
  for (const auto& include : includes_of(file)) {
    const auto target = include.ours ? file_of(include.name) : std::string();
    if (target.empty()) continue;
    const auto room = room_of(target);
    room == "tests" ? found.merge(included_rooms(target, done)) : void(found.insert(room));
  }
  return found;
}

/// What is built and linked for the tests of a room is that room and what stands below it: they say what it does, and
/// nobody waits for the rest. Rooms that take whole configurations have them made by core/compile.
TEST(House, TestsSeeTheRoomThatTheyTest) {
  const auto all = rooms();
  const auto compiled = sees(all, "core/compile");
  for (const auto& room : all) {
    if (!fs::exists(fs::path(test::source_dir()) / "tests" / room.folder)) continue;
    auto may = sees(all, room.folder);
    if (room.folder == "core/compare" || room.folder == "core/exports") may.insert(compiled.begin(), compiled.end());
    for (const auto& file : sources("tests/" + room.folder)) {
      Names done;
      for (const auto& other : included_rooms(file, done)) EXPECT_TRUE(may.contains(other)) << file << ": " << other;
    }
  }
}

TEST(House, NoFoldersIncludeEachOther) {
  Graph graph;
  for (const char* place : {"core", "eni", "ui", "app"}) {
    for (const auto& file : sources(place)) {
      for (const auto& include : includes_of(file)) {
        if (const auto target = include.ours ? file_of(include.name) : std::string(); !target.empty())
          graph.add(folder_of(file), folder_of(target));
      }
    }
  }
  EXPECT_EQ(graph.circle(), std::vector<std::string>());
}

TEST(House, OnlookersSeeTheChannelsAndNotTheCore) {
  for (const char* place : {"ui", "eni"}) {
    for (const auto& file : sources(place)) {
      for (const auto& include : includes_of(file)) {
        const auto target = include.ours ? file_of(include.name) : std::string();
        const auto room = target.empty() ? std::string() : room_of(target);
        const bool core = room == "core/sim" || room == "core/master" || room == "core/link" || room == "core/capture";
        EXPECT_FALSE(core) << file << " includes " << target;
        EXPECT_FALSE(room == "app") << file << " includes " << target;
        if (std::string(place) == "eni") {
          EXPECT_FALSE(room == "ui") << file << " includes " << target;
        }
      }
    }
  }
}

TEST(House, TheCoreKnowsNeitherQtNorXml) {
  for (const char* place : {"core", "eni", "app/cli", "app/composition"}) {
    for (const auto& file : sources(place)) {
      for (const auto& include : includes_of(file)) {
        EXPECT_FALSE(!include.ours && (include.name.front() == 'Q' || include.name.starts_with("qwt"))) << file;
        EXPECT_FALSE(std::string(place) == "core" && include.name == "tinyxml2.h") << file;
      }
    }
  }
}

/// The headers that a room's README offers to other rooms, as sources name them in the tree.
Names public_headers(const std::string& folder) {
  const auto text = text_of(folder + "/README.md");
  const std::string title = "- **Public headers:**";
  const auto begin = text.find(title);
  if (begin == std::string::npos) return {};
  auto end = text.find('\n', begin);
  while (text.compare(end, 3, "\n  ") == 0) end = text.find('\n', end + 1);
  const auto list = text.substr(begin, end - begin);
  static const std::regex pattern("`([^`]+)`");
  Names names;
  for (std::sregex_iterator it(list.begin(), list.end(), pattern), none; it != none; ++it)
    names.insert(folder + "/" + (*it)[1].str());
  return names;
}

/// What is not in the list is the room's own: it can be changed by who knows this room alone. Tests may look in
/// everywhere.
TEST(House, OtherRoomsIncludeOnlyPublicHeaders) {
  std::map<std::string, Names> offered, used;
  auto folders = rooms();
  for (const char* place : {"eni", "ui", "app"}) folders.push_back({place, {}});
  for (const auto& room : folders) offered[room.folder] = public_headers(room.folder);
  for (const auto& room : folders) {
    for (const auto& file : sources(room.folder)) {
      for (const auto& include : includes_of(file)) {
        const auto target = include.ours ? file_of(include.name) : std::string();
        if (target.empty() || room_of(target) == room.folder) continue;
        used[room_of(target)].insert(target);
        EXPECT_TRUE(offered[room_of(target)].contains(target))
            << file << " includes " << target << ", which is not among the public headers in " << room_of(target)
            << "/README.md";
      }
    }
  }
  for (const auto& [folder, headers] : offered) {
    for (const auto& header : headers)
      EXPECT_TRUE(used[folder].contains(header)) << header << " is public in " << folder << "/README.md, for nobody";
  }
}

/// The rows of a table of docs/architecture.md below a title, without those of its head; each the text of its cells.
std::vector<std::vector<std::string>> table_below(const std::string& title) {
  const auto text = text_of("docs/architecture.md");
  const auto begin = text.find("\n## " + title);
  if (begin == std::string::npos) return {};
  std::istringstream lines(text.substr(begin + 1, text.find("\n## ", begin + 1) - begin));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ")) continue;
    std::istringstream cells(line.substr(1));
    auto& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, '|');) row.push_back(cell);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

/// The table names files that are there.
TEST(House, AStrangerFindsWhatTheEtgNames) {
  static const std::regex pattern("`([a-z0-9_]+(/[a-z0-9_]+)+)`");
  std::size_t named = 0;
  for (const auto& row : table_below("Where a stranger looks")) {
    std::size_t in_row = 0;
    for (const auto& cell : row) {
      for (std::sregex_iterator it(cell.begin(), cell.end(), pattern), none; it != none; ++it, ++in_row) {
        const auto file = fs::path(test::source_dir()) / "core" / (*it)[1].str();
        EXPECT_TRUE(fs::exists(file.string() + ".h") || fs::exists(file.string() + ".cpp")) << file;
      }
    }
    EXPECT_GT(in_row, 0U) << row.front() << "names no file";
    named += in_row;
  }
  EXPECT_GE(named, 80U);
}

/// Who searches by the name of a concept gets a file of that name, and the table has it, too.
TEST(House, ConceptsOfTheEtgAreFilesOfTheirNames) {
  std::string table;
  for (const auto& row : table_below("Where a stranger looks")) {
    for (const auto& cell : row) table += cell;
  }
  for (const char* name : {"al_state",
                           "aoe",
                           "coe",
                           "datagram",
                           "device_id",
                           "diagnosis_message",
                           "dl_status",
                           "drift_compensation",
                           "emergency",
                           "eoe",
                           "fmmu",
                           "foe",
                           "frame",
                           "hot_connect",
                           "init_cmd",
                           "mailbox",
                           "pdo_mapping",
                           "process_image",
                           "propagation_delay",
                           "sdo_information",
                           "sii",
                           "soe",
                           "station_address",
                           "station_alias",
                           "start_time",
                           "sync0_cycle",
                           "sync_manager",
                           "sync_unit",
                           "system_time_offset",
                           "topology",
                           "working_counter"}) {
    EXPECT_NE(table.find(std::string("/") + name + "`"), std::string::npos) << name;
  }
}

/// The table of rooms has each room once, in the order in which they may include each other, and none that is not
/// there.
TEST(House, TheTableOfRoomsIsTrue) {
  std::vector<std::string> said;
  for (const auto& row : table_below("Layers")) {
    std::istringstream names(row.front());
    std::string name;
    for (bool first = true; std::getline(names, name, ','); first = false) {
      const auto begin = name.find_first_not_of(' ');
      name = name.substr(begin, name.find_last_not_of(' ') + 1 - begin);
      said.push_back(first ? name : "core/" + name);
    }
  }
  for (const auto& name : said) EXPECT_TRUE(fs::is_directory(fs::path(test::source_dir()) / name)) << name;
  std::vector<std::string> known{"eni", "ui", "app"};
  for (const auto& room : rooms()) known.push_back(room.folder);
  for (const auto& folder : known) EXPECT_EQ(std::ranges::count(said, folder), 1) << folder;
  EXPECT_EQ(said.size(), known.size());
}

TEST(House, EachRoomSaysWhatLivesInIt) {
  auto folders = rooms();
  for (const char* place : {"eni", "ui", "app"}) folders.push_back({place, {}});
  for (const auto& room : folders) {
    const auto text = text_of(room.folder + "/README.md");
    EXPECT_TRUE(text.starts_with("# " + room.folder)) << room.folder << "/README.md";
    EXPECT_NE(text.find("ay include"), std::string::npos) << room.folder;
    EXPECT_NE(text.find("- **Public headers:**"), std::string::npos) << room.folder;
  }
}

TEST(House, EachSourceNamesItsLicence) {
  for (const char* place : {"core", "eni", "ui", "app", "tests"}) {
    for (const auto& file : sources(place)) {
      EXPECT_TRUE(text_of(file).starts_with("// SPDX-License-Identifier: Apache-2.0\n")) << file;
    }
  }
}

// The fuzzers are built by clang 14, and libstdc++ 12 gives it views that it cannot compile; nothing else builds with
// it often enough to notice.
TEST(House, NoSourceUsesARangeThatClangCannotCompile) {
  for (const char* place : {"core", "eni", "app/cli", "app/composition", "tests/fuzz", "tests/support"}) {
    for (const auto& file : sources(place)) {
      const auto text = text_of(file);
      for (const char* name : {"unique", "rotate", "remove", "remove_if", "partition", "stable_partition",
                               "equal_range", "search", "find_end", "subrange"}) {
        EXPECT_EQ(text.find(std::string("ranges::") + name + "("), std::string::npos) << file << ": " << name;
      }
      EXPECT_EQ(text.find("std::views::"), std::string::npos) << file;
    }
  }
}

/// A filter of the whole application sees what other threads have posted, whose types it must not read: WidgetEvents
/// keeps those from all who derive from it.
TEST(House, WhoSeesAllEventsSeesThoseOfWidgetsOnly) {
  for (const char* place : {"ui", "app/gui"}) {
    for (const auto& file : sources(place)) {
      if (file == "ui/widgets/widget_events.cpp") continue;
      const auto text = text_of(file);
      for (const char* application : {"instance()", "qApp", "application", "app"}) {
        for (const char* access : {"->", "."}) {
          EXPECT_EQ(text.find(std::string(application) + access + "installEventFilter"), std::string::npos) << file;
        }
      }
    }
  }
}

}  // namespace
}  // namespace syncline
