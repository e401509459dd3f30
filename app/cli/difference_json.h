// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "app/cli/json.h"

namespace syncline {
struct NetworkDifference;
}  // namespace syncline

namespace syncline::cli {

/// Rows of `where`, `field`, `left`, `right` (docs/json.md).
[[nodiscard]] Json differences_json(const std::vector<NetworkDifference>& differences);

}  // namespace syncline::cli
