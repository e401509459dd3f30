// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace syncline::eni {

/// ETG HexDecValue and xs:int: "#x1A00", "0x1A00", "-3", "4096"; spaces around are ignored. Independent of the locale.
[[nodiscard]] std::optional<std::int64_t> parse_number(std::string_view text);
/// What else is found in the field and can mean but one number: "x1A00", "#1A00", "1A00h", "16#1A00", "# x 1A00",
/// "4.0", "10 ms". Nothing for an empty text.
[[nodiscard]] std::optional<std::int64_t> parse_sloppy_number(std::string_view text);
/// xs:boolean: "true", "1", "false", "0", also "True".
[[nodiscard]] std::optional<bool> parse_bool(std::string_view text);
/// xs:hexBinary, white space tolerated. Not a whole number of bytes or another letter: nothing.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> parse_hex_bytes(std::string_view text);
/// Lower case, no spaces.
[[nodiscard]] std::string hex_bytes(std::span<const std::uint8_t> bytes);
/// "#x1a00"; at least `digits` hexadecimal digits.
[[nodiscard]] std::string hex_dec(std::uint64_t value, int digits = 4);

}  // namespace syncline::eni
