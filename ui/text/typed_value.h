// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>

#include "support/types.h"

namespace syncline::ui {

/// A number as it was typed, with the decimal sign of the locale or a point. `times`: ns, or with ns, us, ms or s
/// behind it. Nothing when it is no such number.
[[nodiscard]] std::optional<double> typedValue(const QString& text, bool times);
/// A time in whole ns, exact; with its unit, without one in ms.
[[nodiscard]] std::optional<Nanoseconds> typedTime(const QString& text);
/// The same, or as the frequency whose period it is, such as "50 Hz"; not zero.
[[nodiscard]] std::optional<Nanoseconds> typedDistance(const QString& text);
/// A value as one may type it, without needless digits.
[[nodiscard]] QString valueToType(double value);

}  // namespace syncline::ui
