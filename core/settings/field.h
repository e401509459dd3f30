// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

#include "config/project.h"
#include "settings/setting.h"

/// Makes a row from a field of the project: getter, setter and "auto" follow from the field's C++ type.
namespace syncline::settings {

/// The slave of a row that stands once for each of them.
inline constexpr auto at_slave = [](auto& project, const Place& place) -> auto& { return project.slaves[place.slave]; };

inline Value to_value(bool field) { return field; }
inline Value to_value(const std::string& field) { return field; }
inline Value to_value(const std::vector<std::uint16_t>& field) { return field; }
template <std::size_t N>
Value to_value(const std::array<std::uint8_t, N>& field) {
  return std::vector<std::uint8_t>(field.begin(), field.end());
}
template <class T>
requires(std::integral<T> || std::is_enum_v<T>) Value to_value(T field) { return static_cast<std::int64_t>(field); }
template <class T>
Value to_value(const std::optional<T>& field) {
  return field ? to_value(*field) : Value{};
}

inline void from_value(const Value& value, bool& field) { field = std::get<bool>(value); }
inline void from_value(const Value& value, std::string& field) { field = std::get<std::string>(value); }
inline void from_value(const Value& value, std::vector<std::uint16_t>& field) {
  field = std::get<std::vector<std::uint16_t>>(value);
}
template <std::size_t N>
void from_value(const Value& value, std::array<std::uint8_t, N>& field) {
  std::ranges::copy_n(std::get<std::vector<std::uint8_t>>(value).begin(), N, field.begin());
}
template <class T>
requires(std::integral<T> || std::is_enum_v<T>) void from_value(const Value& value, T& field) {
  field = static_cast<T>(std::get<std::int64_t>(value));
}
template <class T>
void from_value(const Value& value, std::optional<T>& field) {
  if (std::holds_alternative<Unset>(value)) {
    field.reset();
  } else {
    from_value(value, field.emplace());
  }
}

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// `field(project, place)` gives the field of a const or mutable project.
template <class Field>
[[nodiscard]] Setting field_setting(std::string key, Type type, Words words, Field field) {
  Setting setting{.key = std::move(key), .type = std::move(type), .words = std::move(words), .read = {}, .write = {}};
  setting.read = [field](const Project& project, const Place& place) { return to_value(field(project, place)); };
  setting.write = [field](Project& project, const Place& place, const Value& value) -> Status {
    from_value(value, field(project, place));
    return {};
  };
  using T = std::remove_cvref_t<decltype(field(std::declval<Project&>(), std::declval<const Place&>()))>;
  if constexpr (kIsOptional<T>) setting.unset = "auto";
  return setting;
}

/// A field of a slave: `field(slave)`.
template <class Field>
[[nodiscard]] Setting slave_setting(const std::string& name, Type type, Words words, Field field) {
  return field_setting(
      "slave.N." + name, std::move(type), std::move(words), [field](auto& project, const Place& place) -> auto& {
        return field(project.slaves[place.slave]);
      });
}

/// The row with `unset` called otherwise than "auto".
[[nodiscard]] inline Setting with_unset(Setting setting, std::string word) {
  setting.unset = std::move(word);
  return setting;
}
/// The row with what it stands for while it is unset: `automatic(project, place)`.
template <class Automatic>
[[nodiscard]] Setting with_automatic(Setting setting, Automatic automatic) {
  setting.automatic = std::move(automatic);
  return setting;
}

/// The rows for those devices only that have a use for them.
[[nodiscard]] inline std::vector<Setting> for_devices(std::vector<Setting> rows,
                                                      bool (*applies)(const SlaveSettings&)) {
  for (auto& row : rows) row.applies = applies;
  return rows;
}

inline void append(std::vector<Setting>& table, std::vector<Setting> part) {
  table.insert(table.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
}

}  // namespace syncline::settings
