// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "settings/setting.h"

namespace syncline::ui {

/// A value for a setting of the table (settings/settings_table.h).
struct SettingEdit {
  const settings::Setting* setting = nullptr;
  settings::Place place;
  settings::Value value;
};

}  // namespace syncline::ui
