// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "channels/values/delay_warning.h"

namespace syncline {

/// What a finding of the delay measurement means, for people.
[[nodiscard]] std::string delay_warning_text(dc::DelayWarning warning, std::int64_t value);

}  // namespace syncline
