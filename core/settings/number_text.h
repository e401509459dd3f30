// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "support/types.h"

/// Numbers as they stand in settings: exact, without locale.
namespace syncline::settings {

/// Decimal or 0x hexadecimal, nothing around it.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);
/// As parse_integer() in base 16 without a prefix, for one byte.
[[nodiscard]] std::optional<std::uint8_t> parse_hex_byte(std::string_view two_digits);
/// "62.5" us is 62500 ns; at most three digits behind the point.
[[nodiscard]] std::optional<Nanoseconds> parse_microseconds(std::string_view text);
/// "62.5": no needless zeros.
[[nodiscard]] std::string format_microseconds(Nanoseconds value);

}  // namespace syncline::settings
