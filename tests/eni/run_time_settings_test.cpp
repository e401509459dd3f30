// SPDX-License-Identifier: Apache-2.0
// Which settings no ENI has a place for: measured by the text of the export.
#include <gtest/gtest.h>

#include "compare/compare_run_time.h"
#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "settings/other_value.h"
#include "settings/settings_table.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

std::string text_in(const Project& project, EniDialect dialect) {
  const auto compiled = compile(project, {dialect});
  return compiled ? write_eni(compiled->config, style_of(dialect)) : std::string();
}

/// Whether any other value of the setting changes the text in any dialect.
bool changes_the_eni(const settings::Setting& setting, const Project& project) {
  for (const auto& value : settings::other_values(setting, project, {})) {
    auto other = project;
    if (!settings::set_value(setting, other, {}, value)) continue;
    for (const auto dialect : {EniDialect::kEcEngineer, EniDialect::kTwinCat}) {
      const auto text = text_in(other, dialect);
      if (!text.empty() && text != text_in(project, dialect)) return true;
    }
  }
  return false;
}

TEST(RunTimeSettings, AreThoseThatNoLineOfAnEniHolds) {
  auto project = sample::project({sample::coupler(), sample::servo(), sample::servo()});
  std::size_t asked = 0;
  for (const auto& setting : settings::table()) {
    if (setting.of_slave() || setting.items) continue;
    const bool monitored = setting.key.starts_with("master.dc.sync_window_");
    project.master.dc.sync_window.enabled = monitored;
    EXPECT_FALSE(settings::other_values(setting, project, {}).empty()) << setting.key;
    if (!is_unsaid_setting(setting.key) || setting.key == "master.dc.mode") continue;
    EXPECT_FALSE(changes_the_eni(setting, project)) << setting.key;
    ++asked;
  }
  EXPECT_GT(asked, 20U);
  EXPECT_FALSE(is_unsaid_setting("master.dc.sync_window"));
}

TEST(RunTimeSettings, AnEniDoesNotTellAllModesOfTheDcmApart) {
  ASSERT_TRUE(is_unsaid_setting("master.dc.mode"));
  auto left = sample::small_machine(), right = left;
  left.master.dc.dcm.mode = DcmMode::kMasterShift;
  right.master.dc.dcm.mode = DcmMode::kOff;
  EXPECT_EQ(text_in(left, EniDialect::kEcEngineer), text_in(right, EniDialect::kEcEngineer));
}

}  // namespace
}  // namespace syncline::eni
