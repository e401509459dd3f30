// SPDX-License-Identifier: Apache-2.0
// What docs/project-keys.md and the window say of a setting's place in the ENI is so: measured by the text of the
// export.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "compare/compare_run_time.h"
#include "settings/other_value.h"
#include "settings/settings_keys.h"
#include "settings/settings_table.h"
#include "tests/support/eni_effect.h"
#include "tests/support/own_devices.h"
#include "tests/support/random_project.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

using test::elements_of;
using test::eni_text;
using test::EniEffect;
using test::EniElements;
using test::is_meant;
using test::named_in;
using test::other_paths;

constexpr int kProjects = 120;
/// Exports of a setting that no ENI holds.
constexpr int kEnoughTries = 200;
constexpr EniDialect kDialects[] = {EniDialect::kEcEngineer, EniDialect::kTwinCat};

/// More exports would tell nothing new about what the column names.
bool is_known(const EniEffect& effect, const std::string& column) {
  const auto names = named_in(column);
  return names.empty() ? effect.tried >= kEnoughTries
                       : std::ranges::all_of(names, [&](const auto& name) { return effect.holds(name); });
}

class Measured {
 public:
  void add(const Project& project) {
    std::string before[std::size(kDialects)];
    EniElements elements[std::size(kDialects)];
    for (std::size_t i = 0; i < std::size(kDialects); ++i) {
      before[i] = eni_text(project, kDialects[i]);
      elements[i] = elements_of(before[i]);
    }
    if (before[0].empty()) return;
    ++projects_;
    for (const auto& setting : settings::table()) {
      auto& effect = effects_[setting.key];
      for (const auto& place : places(setting, project)) {
        if (is_known(effect, setting.words.eni)) break;
        for (const auto& value : settings::other_values(setting, project, place)) {
          auto other = project;
          if (!settings::set_value(setting, other, place, value)) continue;
          for (std::size_t i = 0; i < std::size(kDialects); ++i) {
            const auto after = eni_text(other, kDialects[i]);
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
  [[nodiscard]] const std::map<std::string, EniEffect>& effects() const { return effects_; }
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
  std::map<std::string, EniEffect> effects_;
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
  EXPECT_EQ(eni_text(left, EniDialect::kEcEngineer), eni_text(right, EniDialect::kEcEngineer));
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
