// SPDX-License-Identifier: Apache-2.0
#include "settings/setting.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/project.h"
#include "reasons/because.h"

namespace syncline::settings {

std::string type_text(const Setting& setting) {
  return setting.type_words.empty() ? type_text(setting.type) : setting.type_words;
}

std::string range_text(const Setting& setting) {
  if (!setting.range_words.empty()) return setting.range_words;
  return (setting.unset.empty() ? "" : setting.unset + ", ") + range_text(setting.type);
}

std::string preset_text(const Setting& setting) {
  if (!setting.words.preset.empty()) return setting.words.preset;
  if (setting.items) return {};
  Project fresh;
  if (setting.of_slave()) fresh.slaves.emplace_back();
  const auto text = text_of(setting, fresh, {});
  return text.empty() ? "nothing" : text;
}

std::string eni_text(const Words& words) { return words.eni.empty() ? "nothing: " + words.no_eni : words.eni; }

std::string text_of(const Setting& setting, const Project& project, const Place& place) {
  const auto value = setting.read(project, place);
  if (setting.format) return setting.format(project, place, value);
  return std::holds_alternative<Unset>(value) ? setting.unset : format_value(setting.type, value);
}

std::string text_with_unit(const Setting& setting, const Project& project, const Place& place) {
  const auto text = text_of(setting, project, place);
  const auto* number = std::get_if<Number>(&setting.type);
  const bool plain = number == nullptr || number->unit.empty() || text == setting.unset;
  return plain ? text : fmt::format("{} {}", text, number->unit);
}

Status set_value(const Setting& setting, Project& project, const Place& place, const Value& value) {
  if (std::holds_alternative<Unset>(value)) {
    if (setting.unset.empty()) return bad_value(because("the setting needs a value"));
  } else if (auto status = check_value(setting.type, value); !status) {
    return status;
  } else if (setting.options && std::holds_alternative<Choice>(setting.type)) {
    const auto options = setting.options(project, place);
    const bool offered =
        value == setting.read(project, place) || std::ranges::find(options, value, &Option::value) != options.end();
    if (!offered) return bad_value(because("\"{text}\" is not to be had here", format_value(setting.type, value)));
  }
  return setting.write(project, place, value);
}

Status set_text(const Setting& setting, Project& project, const Place& place, std::string_view text) {
  if (!setting.unset.empty() && text == setting.unset) return setting.write(project, place, Value{});
  const auto value = setting.parse ? setting.parse(project, place, text) : parse_value(setting.type, text);
  if (!value) return tl::unexpected(value.error());
  return setting.write(project, place, *value);
}

Value effective_value(const Setting& setting, const Project& project, const Place& place) {
  auto value = setting.read(project, place);
  const bool unset = std::holds_alternative<Unset>(value);
  return unset && setting.automatic ? setting.automatic(project, place) : value;
}

Range working_range(const Setting& setting, const Project& project, const Place& place) {
  const auto& whole = std::get<Number>(setting.type).range;
  if (!setting.works) return whole;
  const auto part = setting.works(project, place);
  return {std::max(whole.low, part.low), std::min(whole.high, part.high)};
}

Status check_number(const Setting& setting, const Project& project, const Place& place) {
  const auto value = effective_value(setting, project, place);
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number == nullptr) return {};
  const auto range = working_range(setting, project, place);
  if (range.contains(*number)) return {};
  return fail(ErrorCode::kBadValue, setting.key, outside(std::get<Number>(setting.type), *number, range));
}

std::vector<Place> numbered(std::size_t slave, std::size_t count) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back({slave, static_cast<std::uint32_t>(i), 0});
  return places;
}

}  // namespace syncline::settings
