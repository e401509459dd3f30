// SPDX-License-Identifier: Apache-2.0
#include "compare/compare_settings.h"

#include <algorithm>

#include "config/project.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

using settings::Place;
using settings::Setting;

std::vector<Place> places_of(const Setting& setting, const Project& project, std::size_t slave) {
  return setting.items ? setting.items(project, slave) : std::vector<Place>{{.slave = slave}};
}

bool is_name(const std::string& key) { return key.ends_with(".name") || key.starts_with("slave.N.variable."); }

void compare(const Setting& setting, const Project& left, const Project& right, std::size_t slave,
             std::vector<SettingDifference>& out) {
  auto places = places_of(setting, left, slave);
  const auto ours = places;
  const auto theirs = places_of(setting, right, slave);
  for (const auto& place : theirs) {
    if (std::ranges::find(ours, place) == ours.end()) places.push_back(place);
  }
  for (const auto& place : places) {
    const auto text = [&](const Project& project, const std::vector<Place>& known) {
      return std::ranges::find(known, place) == known.end() ? std::string() : text_of(setting, project, place);
    };
    auto one = text(left, ours), other = text(right, theirs);
    if (one == other) continue;
    const bool both = !one.empty() && !other.empty();
    const bool same = both && effective_value(setting, left, place) == effective_value(setting, right, place);
    out.push_back({&setting, place, std::move(one), std::move(other), !same && !is_name(setting.key)});
  }
}

}  // namespace

std::vector<SettingDifference> compare_settings(const Project& left, const Project& right) {
  std::vector<SettingDifference> out;
  for (const auto& setting : settings::table()) {
    if (!setting.of_slave()) compare(setting, left, right, 0, out);
  }
  const auto slaves = std::min(left.slaves.size(), right.slaves.size());
  for (std::size_t slave = 0; slave < slaves; ++slave) {
    const auto& a = left.slaves[slave];
    const auto& b = right.slaves[slave];
    if (a == b || !(a.device.identity == b.device.identity)) continue;
    for (const auto& setting : settings::table()) {
      if (setting.of_slave()) compare(setting, left, right, slave, out);
    }
  }
  return out;
}

}  // namespace syncline
