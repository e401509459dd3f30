// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "support/result.h"
#include "support/types.h"

namespace syncline::cli {

/// "20s", "500ms", "2min", "1.5s"; a bare number is seconds. kBadValue otherwise or when not positive.
[[nodiscard]] Result<Nanoseconds> parse_duration(std::string_view text);

}  // namespace syncline::cli
