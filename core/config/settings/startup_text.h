// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "config/device_description.h"
#include "support/result.h"

namespace syncline::settings {

/// "PS,SP 0x6060:00=08 complete fixed off timeout=500 # comment": transitions, object, data in wire order (hexadecimal),
/// then the options that are set. The comment is everything behind " # ".
[[nodiscard]] std::string format_startup(const StartupCommand& command);
/// kBadValue with what is wrong in it; the subject stays empty.
[[nodiscard]] Result<StartupCommand> parse_startup(std::string_view text);

}  // namespace syncline::settings
