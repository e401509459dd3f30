// SPDX-License-Identifier: Apache-2.0
#include "compare/compare_run_time.h"

#include <set>

#include "compare/difference_list.h"
#include "config/project.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

/// What commands say is compared there.
bool stands_in_commands(const std::string& key) {
  static const std::set<std::string> keys = {"master.dc.enabled", "master.dc.reference_clock", "master.dc.sync_window",
                                             "master.dc.show_64bit_system_time"};
  return keys.contains(key);
}

bool is_run_time(const std::string& key) {
  return (key.starts_with("master.dc.") || key.starts_with("master.recovery.") ||
          key.starts_with("master.real_time.")) &&
         !stands_in_commands(key);
}

}  // namespace

bool is_unsaid_setting(const std::string& key) {
  if (!is_run_time(key)) return false;
  // An ENI does not tell all modes apart.
  return key == "master.dc.mode" || settings::row(key).words.eni.empty();
}

std::vector<ConfigDifference> compare_run_time(const Project& left, const Project& right) {
  std::vector<ConfigDifference> out;
  for (const auto& setting : settings::table()) {
    if (!is_run_time(setting.key)) continue;
    const auto value = settings::text_of(setting, left, {}), other = settings::text_of(setting, right, {});
    if (other == value) continue;
    ConfigDifference difference;
    difference.group = DifferenceGroup::kRunTime;
    difference.what = comparison::what("difference-setting", fig::text<"setting">(setting.key));
    difference.what.place.key = setting.key;
    difference.left = value.empty() ? "default" : value;
    difference.right = other.empty() ? "default" : other;
    out.push_back(std::move(difference));
  }
  return out;
}

}  // namespace syncline
