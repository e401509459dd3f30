// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "settings/setting_type.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::settings {

struct Place;
struct Setting;

/// What the setting has in a new project, or in a slave of this device that was just added; nothing for an item of a
/// list that such a slave does not have. Pure.
[[nodiscard]] std::optional<Value> default_value(const Setting& setting, const Project& project, const Place& place);

}  // namespace syncline::settings
