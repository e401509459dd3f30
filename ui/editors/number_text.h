// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

namespace syncline::settings {
struct Number;
}  // namespace syncline::settings

namespace syncline::ui {

/// "62.5" in the user's locale, without unit and needless zeros.
[[nodiscard]] QString numberText(const settings::Number& number, std::int64_t value);
/// "µs", "ms"; empty for a bare number.
[[nodiscard]] QString unitText(const settings::Number& number);
/// What a user typed, with or without the unit, with the decimal sign of the locale or a point. Exact; nothing when it
/// is no such number.
[[nodiscard]] std::optional<std::int64_t> parseNumber(const settings::Number& number, QString text);
/// Exact distance of one step of the arrows.
[[nodiscard]] std::int64_t numberStep(const settings::Number& number);

}  // namespace syncline::ui
