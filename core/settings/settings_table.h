// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "settings/setting.h"

namespace syncline {
struct Project;
}  // namespace syncline

/// The one table of settings. Command line, checks, documentation and the window's fields are made from it.
namespace syncline::settings {

/// All rows; master and network first, then slaves. Made once, on the first call.
[[nodiscard]] const std::vector<Setting>& table();

/// The row whose key has placeholders, like "slave.N.alias". Only for keys that are known to exist: ends the program
/// otherwise.
[[nodiscard]] const Setting& row(std::string_view key);

struct SettingRef {
  const Setting* setting = nullptr;
  Place place;
};
/// Row and place of a key like "slave.3.alias". kUnknownKey when the project has no such place; `to_set` finds the
/// place behind the end of a list, too.
[[nodiscard]] Result<SettingRef> find(const Project& project, std::string_view key, bool to_set);

/// "slave.3.alias"
[[nodiscard]] std::string key_of(const Setting& setting, const Place& place);

}  // namespace syncline::settings
