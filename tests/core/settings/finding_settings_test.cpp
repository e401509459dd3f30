// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "findings/finding.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

TEST(FindingSettings, EachSettingThatAFindingNamesIsInTheTable) {
  std::set<std::string> keys;
  for (const auto& row : settings::table()) keys.emplace(row.key);
  for (const FindingWords& row : all_finding_words()) {
    EXPECT_TRUE(row.setting.empty() || keys.contains(std::string(row.setting))) << row.code << " " << row.setting;
  }
}

}  // namespace
}  // namespace syncline
