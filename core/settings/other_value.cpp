// SPDX-License-Identifier: Apache-2.0
#include "settings/other_value.h"

#include <algorithm>

#include "config/project.h"
#include "settings/setting.h"

namespace syncline::settings {
namespace {

using Values = std::vector<Value>;

Values other_numbers(const Number& type, std::int64_t now, const Range& works) {
  const std::int64_t step = type.nanoseconds_as_us ? kMicrosecond : 1;
  Values values;
  for (const auto value : {now + step, now - step, now + 1000 * step, works.low, works.high, std::int64_t{0}})
    if (works.contains(value) && (value != 0 || !type.without_zero)) values.emplace_back(value);
  return values;
}

/// Longer, shorter, with another digit at its end, or the type's example.
Values other_texts(const std::string& now, std::string_view example) {
  Values values{now + "2"};
  if (const auto digit = now.find_last_of("0123456789"); digit != std::string::npos) {
    auto other = now;
    other[digit] = other[digit] == '9' ? '8' : static_cast<char>(other[digit] + 1);
    values.emplace_back(other);
  }
  values.emplace_back(std::string(example));
  values.emplace_back(std::string());
  return values;
}

Values other_indices(const std::vector<std::uint16_t>& now) {
  if (now.empty()) return {};
  return {std::vector<std::uint16_t>(now.begin(), now.end() - 1)};
}

Values of_type(const Setting& setting, const Project& project, const Place& place) {
  const auto now = effective_value(setting, project, place);
  const auto* number = std::get_if<std::int64_t>(&now);
  const auto* text = std::get_if<std::string>(&now);
  if (std::holds_alternative<Switch>(setting.type)) return {true, false};
  if (const auto* type = std::get_if<Number>(&setting.type))
    return other_numbers(*type, number != nullptr ? *number : 0, working_range(setting, project, place));
  if (std::holds_alternative<Text>(setting.type) || (std::holds_alternative<Record>(setting.type) && text != nullptr)) {
    const auto* type = std::get_if<Text>(&setting.type);
    return other_texts(text != nullptr ? *text : std::string(), type != nullptr ? type->example : std::string_view());
  }
  if (std::holds_alternative<MacAddress>(setting.type)) {
    const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&now);
    auto other = bytes != nullptr ? *bytes : std::vector<std::uint8_t>(6);
    if (!other.empty()) other.back() ^= 1;
    return {other};
  }
  if (const auto* indices = std::get_if<std::vector<std::uint16_t>>(&now)) return other_indices(*indices);
  return {};
}

}  // namespace

std::vector<Value> other_values(const Setting& setting, const Project& project, const Place& place) {
  Values values;
  if (setting.options) {
    for (const auto& option : setting.options(project, place)) values.push_back(option.value);
  } else if (const auto* choice = std::get_if<Choice>(&setting.type)) {
    for (const auto& option : choice->options) values.push_back(option.value);
  } else {
    values = of_type(setting, project, place);
  }
  if (!setting.unset.empty()) values.emplace_back(Unset{});
  const auto now = setting.read(project, place);
  const auto useless = [&](const Value& value) {
    return value == now || (!std::holds_alternative<Unset>(value) && !check_value(setting.type, value));
  };
  values.erase(std::remove_if(values.begin(), values.end(), useless), values.end());
  return values;
}

}  // namespace syncline::settings
