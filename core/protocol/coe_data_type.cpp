// SPDX-License-Identifier: Apache-2.0
#include "protocol/coe_data_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace syncline::coe {
namespace {

constexpr std::uint16_t kString = 0x0009, kFirstBits = 0x0030, kLastBits = 0x0037;

using enum ValueKind;
constexpr std::array<DataType, 25> kTypes{{
    {0x0001, "BOOL", kUnsigned, 1},   {0x0002, "SINT", kSigned, 8},    {0x0003, "INT", kSigned, 16},
    {0x0004, "DINT", kSigned, 32},    {0x0005, "USINT", kUnsigned, 8}, {0x0006, "UINT", kUnsigned, 16},
    {0x0007, "UDINT", kUnsigned, 32}, {0x0008, "REAL", kReal, 32},     {kString, "STRING", kText, 0},
    {0x0011, "LREAL", kReal, 64},     {0x0015, "LINT", kSigned, 64},   {0x001B, "ULINT", kUnsigned, 64},
    {0x001E, "BYTE", kUnsigned, 8},   {0x001F, "WORD", kUnsigned, 16}, {0x0020, "DWORD", kUnsigned, 32},
    {0, "LWORD", kUnsigned, 64},      {0x0030, "BIT1", kUnsigned, 1},  {0x0031, "BIT2", kUnsigned, 2},
    {0x0032, "BIT3", kUnsigned, 3},   {0x0033, "BIT4", kUnsigned, 4},  {0x0034, "BIT5", kUnsigned, 5},
    {0x0035, "BIT6", kUnsigned, 6},   {0x0036, "BIT7", kUnsigned, 7},  {0x0037, "BIT8", kUnsigned, 8},
    {0x0030, "BIT", kUnsigned, 1},
}};

}  // namespace

std::span<const DataType> data_types() { return kTypes; }

const DataType* find_data_type(std::uint16_t code) {
  const auto found = std::ranges::find(kTypes, code, &DataType::code);
  return code == 0 || found == kTypes.end() ? nullptr : &*found;
}

const DataType* find_data_type(std::string_view name) {
  const bool has_length = name.starts_with("STRING(") && name.ends_with(')');
  const auto found = std::ranges::find(kTypes, has_length ? std::string_view("STRING") : name, &DataType::name);
  return found == kTypes.end() ? nullptr : &*found;
}

std::string esi_type_name(std::uint16_t type, unsigned bits) {
  if (type == kString) return fmt::format("STRING({})", bits / 8);
  const auto* known = find_data_type(type);
  if (known != nullptr && (type < kFirstBits || type > kLastBits)) return std::string(known->name);
  return bits == 1 ? "BOOL" : fmt::format("BIT{}", bits);
}

}  // namespace syncline::coe
