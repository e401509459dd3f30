// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// What stands on an axis over many decades.
enum class Quantity : unsigned char { kSeconds, kHertz, kNanoseconds, kRatio };

/// Three digits and the unit that suits: "16.0 ms", "250 Hz", "1.27 us" (with the micro sign), "3.20·10^-8" (raised).
/// `value` >= 0, in s, Hz, ns or without a unit.
[[nodiscard]] QString quantityText(Quantity quantity, double value);
/// The same with as few digits as a label of an axis needs: "10 ms", "10^-8".
[[nodiscard]] QString axisText(Quantity quantity, double value);

}  // namespace syncline::ui
