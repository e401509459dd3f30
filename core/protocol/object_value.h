// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/result.h"

namespace syncline {

/// Data type codes of CoE (ETG.1000.6, table 64). 0: not known, the value is bytes.
inline constexpr std::uint16_t kBytesType = 0x0000, kStringType = 0x0009;

/// "UINT" to 0x0006; BYTES and STRING too. kBadValue.
[[nodiscard]] Result<std::uint16_t> data_type_code(std::string_view name);
/// 0x0006 to "UINT"; the code in hexadecimal for a type without a name.
[[nodiscard]] std::string data_type_name(std::uint16_t code);

/// The value in words: numbers in decimal, text as it is, else bytes ("12 ab"). Bytes that do not fit the type are
/// shown as bytes.
[[nodiscard]] std::string value_text(std::uint16_t type, std::span<const std::uint8_t> bytes);
/// Numbers in decimal or with 0x; bytes in hexadecimal, with or without blanks. kBadValue.
[[nodiscard]] Result<std::vector<std::uint8_t>> value_bytes(std::uint16_t type, std::string_view text);

/// "0x1018:01", "1018:1" (both hexadecimal, as in every manual of a device) or "0x1018" alone.
struct ObjectName {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  bool has_sub_index = false;
};
[[nodiscard]] Result<ObjectName> object_name(std::string_view text);

}  // namespace syncline
