// SPDX-License-Identifier: Apache-2.0
#include "settings/settings_keys.h"

#include "config/project.h"
#include "settings/settings_table.h"

namespace syncline {
namespace {

using settings::Place;
using settings::Setting;

void append(std::vector<SettingValue>& out, const Project& project, const Setting& setting, const Place& slave) {
  const auto add = [&](const Place& place) {
    out.push_back({settings::key_of(setting, place), settings::text_of(setting, project, place)});
  };
  if (!setting.items) return add(slave);
  for (const Place& place : setting.items(project, slave.slave)) add(place);
}

}  // namespace

std::vector<SettingDescription> setting_descriptions() {
  std::vector<SettingDescription> descriptions;
  for (const Setting& setting : settings::table()) {
    const auto& words = setting.words;
    descriptions.push_back({setting.key, settings::type_text(setting), settings::range_text(setting), words.help,
                            words.label, settings::preset_text(setting), words.object, words.eni, words.expert,
                            words.no_eni});
  }
  return descriptions;
}

std::vector<SettingValue> list_settings(const Project& project) {
  std::vector<SettingValue> values;
  for (const Setting& setting : settings::table()) {
    if (!setting.of_slave()) append(values, project, setting, {});
  }
  for (std::size_t slave = 0; slave < project.slaves.size(); ++slave) {
    for (const Setting& setting : settings::table()) {
      if (setting.of_slave()) append(values, project, setting, {.slave = slave});
    }
  }
  return values;
}

Result<std::string> get_setting(const Project& project, std::string_view key) {
  const auto found = settings::find(project, key, false);
  if (!found) return tl::unexpected(found.error());
  return settings::text_of(*found->setting, project, found->place);
}

Status set_setting(Project& project, std::string_view key, std::string_view value) {
  const auto found = settings::find(project, key, true);
  if (!found) return tl::unexpected(found.error());
  auto status = settings::set_text(*found->setting, project, found->place, value);
  if (!status) status.error().subject = std::string(key);
  return status;
}

}  // namespace syncline
