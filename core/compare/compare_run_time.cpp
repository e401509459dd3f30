// SPDX-License-Identifier: Apache-2.0
#include "compare/compare_run_time.h"

#include <map>
#include <set>

#include "compare/difference_list.h"
#include "settings/settings_keys.h"
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
  std::map<std::string, std::string> others;
  for (const auto& [key, value] : list_settings(right)) others.emplace(key, value);
  std::vector<ConfigDifference> out;
  for (const auto& [key, value] : list_settings(left)) {
    const auto other = others.find(key);
    if (!is_run_time(key) || other == others.end() || other->second == value) continue;
    ConfigDifference difference;
    difference.group = DifferenceGroup::kRunTime;
    difference.what = comparison::what("difference-setting", fig::text<"setting">(key));
    difference.what.place.key = key;
    difference.left = value.empty() ? "default" : value;
    difference.right = other->second.empty() ? "default" : other->second;
    out.push_back(std::move(difference));
  }
  return out;
}

}  // namespace syncline
