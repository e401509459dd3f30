// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline::settings {

/// The table of docs/project-keys.md (Markdown): a line for each setting.
[[nodiscard]] std::string settings_table_text();

}  // namespace syncline::settings
