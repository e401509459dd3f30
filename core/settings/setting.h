// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "settings/setting_type.h"

namespace syncline {
struct Project;
struct SlaveSettings;
}  // namespace syncline

/// One row of the table of settings: what it is called, what it may be, where it goes, and how a project holds it.
namespace syncline::settings {

/// The numbers inside a key: "slave.3.startup.2" is slave 3, item 2; "slave.3.pdo.map.0x1607" is item 0x1607;
/// "slave.3.variable.0x1607.1" is item 0x1607, sub-item 1.
struct Place {
  std::size_t slave = 0;
  std::uint32_t item = 0, sub = 0;
  bool operator==(const Place&) const = default;
};

/// What people read. Everything but `label` and `help` may be empty.
struct Words {
  std::string label;     // beside a field
  std::string help;      // a sentence
  std::string object{};  // register or object that it is written to: "0x09A0", "0x10F1:02"
  std::string eni{};     // what it changes in the ENI: "DC/ReferenceClock"
  std::string no_eni{};  // why it changes nothing there (not_in_eni.h): a row has one of the two
  bool expert = false;   // few machines need it
  std::string preset{};  // default in words where it depends on the device
};

struct Setting {
  std::string key;  // "N" stands for a slave's position, "K" for an item's number, "0xIIII" for a PDO index
  Type type;
  Words words;
  std::function<Value(const Project&, const Place&)> read;
  /// Takes what the type allows; may refuse what does not suit the device or the project and then leaves it alone.
  std::function<Status(Project&, const Place&, const Value&)> write;

  /// Word for Unset; empty: the setting always has a value.
  std::string unset{};
  /// What Unset stands for here; Unset where nobody knows before the device is asked.
  std::function<Value(const Project&, const Place&)> automatic{};
  /// Of a Number: what works in this project. A value outside of it can be set and is found as a problem.
  std::function<Range(const Project&, const Place&)> works{};
  /// Of a Choice that depends on the project.
  std::function<std::vector<Option>(const Project&, const Place&)> options{};
  /// Instead of parse_value() and format_value().
  std::function<Result<Value>(const Project&, const Place&, std::string_view)> parse{};
  std::function<std::string(const Project&, const Place&, const Value&)> format{};
  /// Instead of what the type says of itself.
  std::string type_words{}, range_words{};
  /// Of a slave: whether its device has a use for it; empty: every device has.
  std::function<bool(const SlaveSettings&)> applies{};
  /// For keys with an item: those that exist. `slave` is 0 for keys of the master.
  std::function<std::vector<Place>(const Project&, std::size_t slave)> items{};
  /// A list that `write` may extend by one takes the number behind the last item.
  bool extendable = false;

  [[nodiscard]] bool of_slave() const { return key.starts_with("slave."); }
};

// ---- what follows from a row

[[nodiscard]] std::string type_text(const Setting& setting);
[[nodiscard]] std::string range_text(const Setting& setting);
/// Default in words: what a new project or a new slave has.
[[nodiscard]] std::string preset_text(const Setting& setting);
/// What it changes in the ENI, or "nothing: " and why.
[[nodiscard]] std::string eni_text(const Words& words);
[[nodiscard]] std::string text_of(const Setting& setting, const Project& project, const Place& place);
/// The same with the unit that a number has: "1500 ms".
[[nodiscard]] std::string text_with_unit(const Setting& setting, const Project& project, const Place& place);
/// Typed setter: kBadValue without subject; the project is unchanged then.
[[nodiscard]] Status set_value(const Setting& setting, Project& project, const Place& place, const Value& value);
[[nodiscard]] Status set_text(const Setting& setting, Project& project, const Place& place, std::string_view text);
/// Its value, or what stands for it while it is unset; Unset where nobody knows.
[[nodiscard]] Value effective_value(const Setting& setting, const Project& project, const Place& place);
/// What works in this project: `works` within the range of the type. For numbers.
[[nodiscard]] Range working_range(const Setting& setting, const Project& project, const Place& place);
/// kBadValue with the key as subject when the number in force is outside working_range().
[[nodiscard]] Status check_number(const Setting& setting, const Project& project, const Place& place);

/// Places 0..count-1 of a slave.
[[nodiscard]] std::vector<Place> numbered(std::size_t slave, std::size_t count);

}  // namespace syncline::settings
