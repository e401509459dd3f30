// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "settings/setting_type.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::settings {

struct Place;
struct Setting;

/// Values that a setting could have instead, the nearest first: for whoever wants to see what depends on it. Legal by
/// its type and options; `write` may still refuse one. Empty where nobody knows any.
[[nodiscard]] std::vector<Value> other_values(const Setting& setting, const Project& project, const Place& place);

}  // namespace syncline::settings
