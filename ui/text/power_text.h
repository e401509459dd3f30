// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// "10⁴", "10⁻³".
[[nodiscard]] QString powerOfTenText(int power);

}  // namespace syncline::ui
