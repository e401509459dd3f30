// SPDX-License-Identifier: Apache-2.0
#include "settings/default_value.h"

#include <algorithm>

#include "config/project.h"
#include "settings/setting.h"

namespace syncline::settings {

std::optional<Value> default_value(const Setting& setting, const Project& project, const Place& place) {
  if (setting.of_slave() && place.slave >= project.slaves.size()) return std::nullopt;
  Project fresh;
  fresh.slaves.resize(setting.of_slave() ? place.slave + 1 : 0);
  if (setting.of_slave()) {
    fresh.slaves[place.slave] =
        default_slave(project.slaves[place.slave].device, static_cast<std::uint16_t>(place.slave));
  }
  if (setting.items) {
    const auto items = setting.items(fresh, place.slave);
    if (std::ranges::find(items, place) == items.end()) return std::nullopt;
  }
  return setting.read(fresh, place);
}

}  // namespace syncline::settings
