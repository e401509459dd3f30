// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::ui {

/// 1, 2 or 5 times a power of ten, not below `least` (> 0), but for rounding.
[[nodiscard]] double roundStep(double least);

}  // namespace syncline::ui
