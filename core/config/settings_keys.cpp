// SPDX-License-Identifier: Apache-2.0
#include "config/settings_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "config/settings/codecs.h"
#include "config/settings/setting_rule.h"

namespace syncline {
namespace {

using settings::Place;
using settings::Rule;

constexpr std::string_view kSlave = "N", kNumber = "K", kIndex = "0xIIII";

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = [] {
    std::vector<Rule> table;
    // Modules come before the PDOs and commands that they bring, so that a list can be applied from the top.
    for (auto part : {settings::master_rules(), settings::task_rules(), settings::slave_rules(),
                      settings::slave_option_rules(), settings::sync_rules(), settings::module_rules(), settings::pdo_rules(),
                      settings::startup_rules(), settings::variable_rules()}) {
      table.insert(table.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
    }
    return table;
  }();
  return all;
}

std::string_view next_part(std::string_view& key) {
  const auto dot = key.find('.');
  const auto part = key.substr(0, dot);
  key = dot == std::string_view::npos ? std::string_view{} : key.substr(dot + 1);
  return part;
}

std::optional<std::uint32_t> small_number(std::string_view text) {
  const bool digit_first = !text.empty() && text.front() >= '0' && text.front() <= '9';
  const auto value = digit_first ? settings::parse_integer(text) : std::nullopt;
  return value && *value <= 0xFFFF ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

/// The numbers in `key` where it has the form of the rule's key.
std::optional<Place> match(const Rule& rule, std::string_view key) {
  Place place;
  std::string_view pattern = rule.key;
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

std::string key_of(const Rule& rule, const Place& place) {
  std::string key;
  bool has_item = false;
  for (std::string_view pattern = rule.key; !pattern.empty();) {
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

bool is_slave_rule(const Rule& rule) { return rule.key.starts_with("slave."); }

struct Found {
  const Rule* rule;
  Place place;
};

Result<Found> find(const Project& project, std::string_view key, bool to_set) {
  const auto unknown = [key](std::string detail) { return fail(ErrorCode::kUnknownKey, std::string(key), std::move(detail)); };
  for (const Rule& rule : rules()) {
    const auto place = match(rule, key);
    if (!place) continue;
    if (is_slave_rule(rule) && place->slave >= project.slaves.size()) {
      return unknown(fmt::format("slaves in the project: {}, counted from 0", project.slaves.size()));
    }
    if (rule.items) {
      const auto items = rule.items(project, place->slave);
      const bool exists = std::ranges::find(items, *place) != items.end();
      const bool extends = to_set && rule.extendable && place->item == items.size();
      if (!exists && !extends) {
        return unknown(is_slave_rule(rule) ? fmt::format("slave {} has no such item", place->slave)
                                           : std::string("there is no such item"));
      }
    }
    return Found{&rule, *place};
  }
  return unknown("list all with \"synclinectl project keys\"");
}

void append(std::vector<SettingValue>& out, const Project& project, const Rule& rule, const Place& slave) {
  const auto add = [&](const Place& place) { out.push_back({key_of(rule, place), rule.get(project, place)}); };
  if (!rule.items) return add(slave);
  for (const Place& place : rule.items(project, slave.slave)) add(place);
}

}  // namespace

std::vector<SettingDescription> setting_descriptions() {
  std::vector<SettingDescription> descriptions;
  for (const Rule& rule : rules()) descriptions.push_back({rule.key, rule.type, rule.range, rule.meaning});
  return descriptions;
}

std::vector<SettingValue> list_settings(const Project& project) {
  std::vector<SettingValue> values;
  for (const Rule& rule : rules()) {
    if (!is_slave_rule(rule)) append(values, project, rule, {});
  }
  for (std::size_t slave = 0; slave < project.slaves.size(); ++slave) {
    for (const Rule& rule : rules()) {
      if (is_slave_rule(rule)) append(values, project, rule, {.slave = slave});
    }
  }
  return values;
}

Result<std::string> get_setting(const Project& project, std::string_view key) {
  const auto found = find(project, key, false);
  if (!found) return tl::unexpected(found.error());
  return found->rule->get(project, found->place);
}

Status set_setting(Project& project, std::string_view key, std::string_view value) {
  const auto found = find(project, key, true);
  if (!found) return tl::unexpected(found.error());
  auto status = found->rule->set(project, found->place, value);
  if (!status) status.error().subject = std::string(key);
  return status;
}

}  // namespace syncline
