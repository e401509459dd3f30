// SPDX-License-Identifier: Apache-2.0
// docs/configurator.md lists where each setting is in the window, made from the pages themselves.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "settings/settings_table.h"
#include "support/ui_test_support.h"
#include "support/whole_file.h"
#include "tests/support/source_dir.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/page.h"
#include "ui/main_window.h"
#include "ui/pages/device_editor.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

const std::string kTableBegin = "<!-- made from the pages -->\n", kTableEnd = "<!-- end -->\n";

std::string fileText(const std::string& file) { return read_whole_file(file).value_or(std::string()); }

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
  return text;
}

std::string pageTable() {
  Workspace workspace(test::virtualEnvironment());
  MainWindow window(workspace);
  std::map<const settings::Setting*, std::string> pages;
  for (const auto* page : window.editor().pages()) {
    const auto node = page->objectName().startsWith(QStringLiteral("master")) ? "master" : "slave";
    for (const auto* setting : page->fields().settings()) {
      auto& places = pages[setting];
      if (places.empty()) places = std::string(node) + ", " + page->title().toStdString();
    }
  }
  std::string text =
      "| key | page | field | default | goes to | in the ENI | expert |\n|---|---|---|---|---|---|---|\n";
  for (const auto& setting : settings::table()) {
    const auto& words = setting.words;
    text += "| `" + setting.key + "` | " + pages[&setting] + " | " + cell(words.label) + " | " +
            cell(settings::preset_text(setting)) + " | " + cell(words.object) + " | " +
            cell(settings::eni_text(words)) + " | " + (words.expert ? "yes" : "") + " |\n";
  }
  return text;
}

TEST(ConfiguratorDocument, SaysWhereEachSettingIs) {
  const auto file = test::source_dir() + "/docs/configurator.md";
  const auto table = pageTable();
  auto text = fileText(file);
  const auto begin = text.find(kTableBegin), end = text.find(kTableEnd);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  if (std::getenv("SYNCLINE_WRITE_GOLDEN") != nullptr) {
    text.replace(begin + kTableBegin.size(), end - begin - kTableBegin.size(), "\n" + table + "\n");
    ASSERT_TRUE(write_whole_file(file, text).has_value());
  }
  EXPECT_NE(text.find(table), std::string::npos) << "SYNCLINE_WRITE_GOLDEN=1 test_ui writes it";
  EXPECT_EQ(table.find("` |  | "), std::string::npos) << "a key without a page";
}

/// Page, default, register and element of the ENI beside the fields of other tools are those of the table below.
TEST(ConfiguratorDocument, SaysTheSameBesideTheFieldsOfOtherTools) {
  const auto text = fileText(test::source_dir() + "/docs/configurator.md");
  const auto cells = [](const std::string& line) {
    std::vector<std::string> out;
    std::istringstream rest(line);
    for (std::string one; std::getline(rest, one, '|');) {
      one.erase(0, std::min(one.find_first_not_of(' '), one.size()));
      one.erase(one.find_last_not_of(' ') + 1);
      out.push_back(one);
    }
    return out;
  };
  std::map<std::string, std::vector<std::string>> known;
  std::istringstream table(text.substr(text.find(kTableBegin)));
  for (std::string line; std::getline(table, line);) {
    const auto row = cells(line);
    if (row.size() > 6 && row[1].starts_with('`')) known[row[1]] = {row[2], row[4], row[5], row[6]};
  }
  std::istringstream fields(text.substr(0, text.find(kTableBegin)));
  int compared = 0;
  for (std::string line; std::getline(fields, line);) {
    const auto row = cells(line);
    if (row.size() != 7 || !row[2].starts_with('`')) continue;
    EXPECT_EQ(known[row[2]], (std::vector<std::string>{row[3], row[4], row[5], row[6]})) << row[2];
    ++compared;
  }
  EXPECT_GE(compared, 30) << "fields of the two pages for distributed clocks";
}

/// Keys that the words above the table name exist.
TEST(ConfiguratorDocument, NamesKeysThatExist) {
  const auto text = fileText(test::source_dir() + "/docs/configurator.md");
  std::set<std::string> known;
  for (const auto& setting : settings::table()) known.insert(setting.key);
  static const std::regex key("`((?:master|slave\\.N|network)\\.[A-Za-z0-9_.]+)`");
  for (std::sregex_iterator it(text.begin(), text.end(), key), end; it != end; ++it)
    EXPECT_TRUE(known.contains((*it)[1])) << (*it)[1];
}

}  // namespace
}  // namespace syncline::ui
