// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "settings/setting.h"

namespace syncline {

struct Project;

/// A setting that two projects hold differently.
struct SettingDifference {
  const settings::Setting* setting = nullptr;
  settings::Place place;
  std::string left, right;  // text forms; "" where a list has no such item
  /// A machine would be another: no name, and not the value that stands for what is unset on the other side.
  bool matters = true;
};

/// Settings of the master, and of slaves in the same place, that differ; in the order of the table, slave by slave.
/// What stands in one place only of projects with different slaves is not compared: see compare_found().
[[nodiscard]] std::vector<SettingDifference> compare_settings(const Project& left, const Project& right);

}  // namespace syncline
