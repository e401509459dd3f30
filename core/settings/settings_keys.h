// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/result.h"

/// Every setting of a project has a key ("master.cycle_time_us", "slave.3.dc.op_mode",
/// "slave.3.pdo.rx") and a text form. The command line, the findings and the window's tool tips
/// use the same keys.
namespace syncline {

struct Project;

struct SettingValue {
  std::string key;
  std::string value;
};
struct SettingDescription {
  std::string key;   // with "N" for the slave position
  std::string type;  // "integer us", "name", "list of PDO indices"
  std::string range;
  std::string meaning;
  std::string name;          // beside a field of the window
  std::string preset;        // what a new project or a new slave has; empty for lists
  std::string goes_to, eni;  // register or object; ENI element; may be empty
  bool expert = false;
  std::string no_eni{};  // why it changes nothing in the ENI; empty where `eni` names what it changes
};

[[nodiscard]] std::vector<SettingDescription> setting_descriptions();
[[nodiscard]] std::vector<SettingValue> list_settings(const Project& project);
[[nodiscard]] Result<std::string> get_setting(const Project& project, std::string_view key);
/// Applies one edit; the project is unchanged when the result is an error (kUnknownKey, kBadValue).
[[nodiscard]] Status set_setting(Project& project, std::string_view key, std::string_view value);

}  // namespace syncline
