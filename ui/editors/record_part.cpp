// SPDX-License-Identifier: Apache-2.0
#include "ui/editors/record_part.h"

#include <algorithm>

#include "settings/settings_table.h"

namespace syncline::ui {

std::vector<SettingEdit> itemEdits(const char* key, std::size_t slave, const Records& before, const Records& after) {
  const auto shorter = std::min(before.size(), after.size());
  std::size_t prefix = 0, suffix = 0;
  while (prefix < shorter && before[prefix] == after[prefix]) ++prefix;
  while (suffix < shorter - prefix && before[before.size() - 1 - suffix] == after[after.size() - 1 - suffix]) ++suffix;
  std::vector<SettingEdit> edits;
  const auto set = [&](std::size_t number, const std::string& text) {
    edits.push_back(
        {&settings::row(key), {.slave = slave, .item = static_cast<std::uint32_t>(number)}, settings::Value{text}});
  };
  // A removed one goes first, so that its name is free; behind an added one all move on.
  for (auto count = before.size(); count > after.size(); --count) set(prefix, {});
  const auto end = after.size() > before.size() ? after.size() : after.size() - suffix;
  for (auto number = prefix; number < end; ++number) set(number, after[number]);
  return edits;
}

}  // namespace syncline::ui
