// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "app/cli/json.h"

namespace syncline {
struct Interval;
}  // namespace syncline

namespace syncline::cli {

/// `[low, high]` with three digits behind the point, rounded away from its middle so that it loses nothing; null
/// without one. Six digits for what is a small number of large units (`fine`: ppm).
[[nodiscard]] Json interval_json(const std::optional<Interval>& interval, bool fine = false);

}  // namespace syncline::cli
