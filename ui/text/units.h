// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string_view>

#include "support/types.h"

/// Numbers as the user reads them: unit chosen by size, fixed digits, the user's locale.
namespace syncline::ui {

/// "250 ns", "62.500 us", "1.000 ms" (with the micro sign); the sign always stands for signed quantities.
[[nodiscard]] QString timeText(Nanoseconds value);
[[nodiscard]] QString signedTimeText(Nanoseconds value);
/// "≤ 15 ns", of an upper estimate.
[[nodiscard]] QString atMostText(const QString& estimate);
/// A figure in ns as these take it: to the nearest one.
[[nodiscard]] Nanoseconds wholeNs(double value);
/// "12.345 s": a moment of a run, since the zero of the plots' axis; negative before the first sample.
[[nodiscard]] QString runTimeText(Nanoseconds since_begin);
/// A set cycle time without needless zeros: "1 ms", "250 us", "62.5 us".
[[nodiscard]] QString cycleText(Nanoseconds value);
[[nodiscard]] QString ppmText(double ppm);
/// An estimate with half of its 95 % interval: "12 ns ± 3 ns". As it is without one. Never narrower than it is.
[[nodiscard]] QString withSpreadText(const QString& estimate, const std::optional<double>& half_width_ns);
[[nodiscard]] QString withSpreadPpmText(double ppm, const std::optional<double>& half_width);
[[nodiscard]] QString countText(std::uint64_t value);
/// Without a unit, as plots hold it: whole ones as such, others with seven digits.
[[nodiscard]] QString numberText(double value);
/// "0x0300": `digits` hexadecimal digits, as registers and identities are written in ESI and ENI.
[[nodiscard]] QString hexText(std::uint64_t value, int digits);
/// "0x607A:00": an object of a dictionary, a PDO's entry or a start-up command's.
[[nodiscard]] QString objectText(std::uint16_t index, std::uint8_t sub_index);
/// "14 Bit", "4 Byte".
[[nodiscard]] QString bitsText(std::uint32_t bits);

/// "10⁻⁶" for 6, "1" for 0.
[[nodiscard]] QString decadeText(int decades_below_one);
/// Of a logarithmic axis of counts: "1", "1000", "10\u2074".
[[nodiscard]] QString countDecadeText(int decade);

/// A dash, where there is nothing to show.
[[nodiscard]] QString noText();
[[nodiscard]] QString fromView(std::string_view text);

}  // namespace syncline::ui
