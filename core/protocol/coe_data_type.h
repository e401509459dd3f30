// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace syncline::coe {

/// How the bytes of a value are to be read.
enum class ValueKind : std::uint8_t { kSigned, kUnsigned, kReal, kText };

/// Data type of an object (ETG.1000.6, table 64; ETG.1020) with its name in ESI and ENI files.
struct DataType {
  std::uint16_t code = 0;  // 0: has a name and a length in files, no number
  std::string_view name;
  ValueKind kind = ValueKind::kUnsigned;
  std::uint16_t bits = 0;  // 0: any length
};

[[nodiscard]] std::span<const DataType> data_types();
/// Null when there is none of that number or name. "STRING(8)" is a STRING.
[[nodiscard]] const DataType* find_data_type(std::uint16_t code);
[[nodiscard]] const DataType* find_data_type(std::string_view name);

/// Data type number as ESI names it; by its width where the number has no name there.
[[nodiscard]] std::string esi_type_name(std::uint16_t type, unsigned bits);

}  // namespace syncline::coe
