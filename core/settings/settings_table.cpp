// SPDX-License-Identifier: Apache-2.0
#include "settings/settings_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "reasons/because.h"
#include "settings/field.h"
#include "settings/number_text.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr std::string_view kSlave = "N", kNumber = "K", kIndex = "0xIIII";

std::string_view next_part(std::string_view& key) {
  const auto dot = key.find('.');
  const auto part = key.substr(0, dot);
  key = dot == std::string_view::npos ? std::string_view{} : key.substr(dot + 1);
  return part;
}

std::optional<std::uint32_t> small_number(std::string_view text) {
  const bool digit_first = !text.empty() && text.front() >= '0' && text.front() <= '9';
  const auto value = digit_first ? parse_integer(text) : std::nullopt;
  return value && *value <= 0xFFFF ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

/// The numbers in `key` where it has the form of the setting's key.
std::optional<Place> match(const Setting& setting, std::string_view key) {
  Place place;
  std::string_view pattern = setting.key;
  bool has_item = false;
  if (key.ends_with('.')) return std::nullopt;
  while (!pattern.empty() && !key.empty()) {
    const auto wanted = next_part(pattern);
    const auto part = next_part(key);
    if (wanted != kSlave && wanted != kNumber && wanted != kIndex) {
      if (wanted != part) return std::nullopt;
      continue;
    }
    const auto number = small_number(part);
    if (!number) return std::nullopt;
    if (wanted == kSlave) {
      place.slave = *number;
    } else {
      (has_item ? place.sub : place.item) = *number;
      has_item = true;
    }
  }
  return pattern.empty() && key.empty() ? std::optional(place) : std::nullopt;
}

}  // namespace

std::string key_of(const Setting& setting, const Place& place) {
  std::string key;
  bool has_item = false;
  for (std::string_view pattern = setting.key; !pattern.empty();) {
    const auto part = next_part(pattern);
    if (!key.empty()) key += '.';
    if (part == kSlave) {
      key += std::to_string(place.slave);
    } else if (part == kNumber) {
      key += std::to_string(has_item ? place.sub : place.item);
      has_item = true;
    } else if (part == kIndex) {
      key += fmt::format("0x{:04x}", place.item);
      has_item = true;
    } else {
      key += part;
    }
  }
  return key;
}

const std::vector<Setting>& table() {
  static const std::vector<Setting> all = [] {
    std::vector<Setting> rows;
    // Modules come before the PDOs and commands that they bring, so that a list can be applied from the top.
    for (auto part : {master_rows(), dc_rows(), dcm_rows(), image_rows(), slave_rows(), slave_dc_rows(),
                      slave_option_rows(), mailbox_rows(), sync_rows(), module_rows(), pdo_rows(), startup_rows(),
                      message_rows(), own_command_rows(), variable_rows()}) {
      append(rows, std::move(part));
    }
    return rows;
  }();
  return all;
}

Result<SettingRef> find(const Project& project, std::string_view key, bool to_set) {
  const auto unknown = [key](Reason detail) {
    return fail(ErrorCode::kUnknownKey, std::string(key), std::move(detail));
  };
  for (const Setting& setting : table()) {
    const auto place = match(setting, key);
    if (!place) continue;
    if (setting.of_slave() && place->slave >= project.slaves.size()) {
      return unknown(because("slaves in the project: {count}, counted from 0", project.slaves.size()));
    }
    if (setting.items) {
      const auto items = setting.items(project, place->slave);
      const bool exists = std::ranges::find(items, *place) != items.end();
      const bool extends = to_set && setting.extendable && place->item == items.size();
      if (!exists && !extends) {
        return unknown(setting.of_slave() ? because("slave {position} has no such item", place->slave)
                                          : because("there is no such item"));
      }
    }
    return SettingRef{&setting, *place};
  }
  return unknown(because("list all with \"synclinectl project keys\""));
}

const Setting& row(std::string_view key) {
  const auto found = std::ranges::find(table(), key, &Setting::key);
  if (found == table().end()) std::abort();  // a key of ours that the table does not have
  return *found;
}

}  // namespace syncline::settings
