// SPDX-License-Identifier: Apache-2.0
// What docs/project-keys.md and the window say of a setting's place in the ENI is so: measured by the text of the
// export.
#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "compare/compare_run_time.h"
#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "settings/other_value.h"
#include "settings/settings_keys.h"
#include "settings/settings_table.h"
#include "tests/support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

constexpr int kProjects = 120;
/// Exports of a setting that no ENI holds.
constexpr int kEnoughTries = 200;
constexpr EniDialect kDialects[] = {EniDialect::kEcEngineer, EniDialect::kTwinCat};

std::string text_in(const Project& project, EniDialect dialect) {
  const auto compiled = compile(project, {dialect});
  return compiled ? write_eni(compiled->config, style_of(dialect)) : std::string();
}

/// Each element's path and text, as often as it stands there.
using Elements = std::multiset<std::string>;

void collect(const tinyxml2::XMLElement& element, const std::string& above, Elements& all) {
  const auto path = above + "/" + element.Name();
  std::string own = path + "=" + (element.GetText() != nullptr ? element.GetText() : "");
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next())
    own += std::string(" ") + attribute->Name() + "=" + attribute->Value();
  all.insert(own);
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    collect(*child, path, all);
}

Elements elements_of(const std::string& text) {
  tinyxml2::XMLDocument document;
  document.Parse(text.data(), text.size());
  Elements all;
  if (document.RootElement() != nullptr) collect(*document.RootElement(), "", all);
  return all;
}

/// Paths of the elements that only one of them has, or with another text.
std::set<std::string> other_paths(const Elements& before, const Elements& after) {
  std::vector<std::string> differences;
  std::ranges::set_symmetric_difference(before, after, std::back_inserter(differences));
  std::set<std::string> paths;
  for (const auto& difference : differences) paths.insert(difference.substr(0, difference.find('=')));
  return paths;
}

/// "Slave/Mailbox" is meant by ".../Slave/Mailbox/Recv/PollTime": its steps follow each other there, perhaps with
/// others between.
bool is_meant(const std::string& path, std::string_view named) {
  std::size_t at = 0;
  while (!named.empty()) {
    const auto end = std::min(named.find('/'), named.size());
    const auto step = "/" + std::string(named.substr(0, end));
    at = (path + "/").find(step + "/", at);
    if (at == std::string::npos) return false;
    at += step.size();
    named.remove_prefix(std::min(end + 1, named.size()));
  }
  return true;
}

/// The elements that a column names: "ProcessData/RxPdo, ProcessData/TxPdo (32 bits)".
std::vector<std::string> named_in(std::string column) {
  for (auto open = column.find('('); open != std::string::npos; open = column.find('('))
    column.erase(open, column.find(')', open) + 1 - open);
  std::vector<std::string> names;
  std::istringstream parts(column);
  for (std::string part; std::getline(parts, part, ',');) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    if (!part.empty()) names.push_back(part);
  }
  return names;
}

struct Effect {
  int tried = 0, changed = 0;
  std::set<std::string> paths;
  /// More exports would tell nothing new about what the column names.
  [[nodiscard]] bool is_known(const std::string& column) const {
    const auto names = named_in(column);
    return names.empty() ? tried >= kEnoughTries
                         : std::ranges::all_of(names, [this](const auto& name) { return holds(name); });
  }
  [[nodiscard]] bool holds(const std::string& name) const {
    return std::ranges::any_of(paths, [&](const auto& path) { return is_meant(path, name); });
  }
  [[nodiscard]] std::string some_path() const { return paths.empty() ? "nothing" : *paths.begin(); }
};

class Measured {
 public:
  void add(const Project& project) {
    std::string before[std::size(kDialects)];
    Elements elements[std::size(kDialects)];
    for (std::size_t i = 0; i < std::size(kDialects); ++i) {
      before[i] = text_in(project, kDialects[i]);
      elements[i] = elements_of(before[i]);
    }
    if (before[0].empty()) return;
    ++projects_;
    for (const auto& setting : settings::table()) {
      auto& effect = effects_[setting.key];
      for (const auto& place : places(setting, project)) {
        if (effect.is_known(setting.words.eni)) break;
        for (const auto& value : settings::other_values(setting, project, place)) {
          auto other = project;
          if (!settings::set_value(setting, other, place, value)) continue;
          for (std::size_t i = 0; i < std::size(kDialects); ++i) {
            const auto after = text_in(other, kDialects[i]);
            if (after.empty()) continue;
            ++effect.tried;
            if (after == before[i]) continue;
            ++effect.changed;
            effect.paths.merge(other_paths(elements[i], elements_of(after)));
          }
        }
      }
    }
  }
  [[nodiscard]] const std::map<std::string, Effect>& effects() const { return effects_; }
  [[nodiscard]] int projects() const { return projects_; }

 private:
  static std::vector<settings::Place> places(const settings::Setting& setting, const Project& project) {
    const std::size_t slaves = setting.of_slave() ? project.slaves.size() : 1;
    std::vector<settings::Place> result;
    for (std::size_t slave = 0; slave < slaves; ++slave) {
      if (setting.of_slave() && setting.applies && !setting.applies(project.slaves[slave])) continue;
      if (setting.items) {
        for (const auto& place : setting.items(project, slave)) result.push_back(place);
      } else {
        settings::Place place;
        place.slave = slave;
        result.push_back(place);
      }
    }
    return result;
  }
  std::map<std::string, Effect> effects_;
  int projects_ = 0;
};

TEST(EniColumn, SaysWhatASettingChangesInAnEniAndNothingElse) {
  Measured measured;
  for (std::uint32_t seed = 1; seed <= kProjects; ++seed) measured.add(test::RandomProject(seed).project());
  measured.add(sample::project({sample::coupler(), sample::servo(), sample::servo()}));
  // Settings of device families.
  for (const char* type : {"SL-6751", "SL-XE2", "SL-SV7"})
    measured.add(sample::project({sample::coupler(), sample::own(type)}));
  ASSERT_GT(measured.projects(), kProjects / 2);
  for (const auto& setting : setting_descriptions()) {
    const auto& effect = measured.effects().at(setting.key);
    EXPECT_GT(effect.tried, 0) << setting.key << " is in no project";
    EXPECT_TRUE(!setting.eni.empty() || effect.changed == 0) << setting.key << " changes " << effect.some_path();
    for (const auto& name : named_in(setting.eni)) {
      EXPECT_TRUE(effect.holds(name)) << setting.key << " does not change " << name << ", but " << effect.some_path();
    }
  }
}

/// What an export's report says that no ENI holds follows from the column, but for one.
TEST(EniColumn, AnEniDoesNotTellAllModesOfTheDcmApart) {
  EXPECT_FALSE(is_unsaid_setting("master.dc.sync_window"));
  EXPECT_FALSE(is_unsaid_setting("master.dc.first_slave_is_reference_clock"));
  ASSERT_TRUE(is_unsaid_setting("master.dc.mode"));
  auto left = sample::small_machine(), right = left;
  left.master.dc.dcm.mode = DcmMode::kMasterShift;
  right.master.dc.dcm.mode = DcmMode::kOff;
  EXPECT_EQ(text_in(left, EniDialect::kEcEngineer), text_in(right, EniDialect::kEcEngineer));
}

TEST(EniColumn, IsReadAsItIsWritten) {
  EXPECT_TRUE(is_meant("/EtherCATConfig/Config/Slave/Mailbox/Recv/PollTime", "Slave/Mailbox"));
  EXPECT_TRUE(is_meant("/EtherCATConfig/Config/Slave/Mailbox/Recv/PollTime", "Mailbox/PollTime"));
  EXPECT_FALSE(is_meant("/EtherCATConfig/Config/Slave/Mailbox/Recv", "Recv/Slave"));
  EXPECT_FALSE(is_meant("/EtherCATConfig/Config/Slave/DC/CycleTime0", "DC/CycleTime"));
  EXPECT_EQ(named_in("Slave/DC, Cyclic/Frame/Cmd (BRD 0x092C)"),
            (std::vector<std::string>{"Slave/DC", "Cyclic/Frame/Cmd"}));
  EXPECT_TRUE(named_in("").empty());
}

}  // namespace
}  // namespace syncline::eni
