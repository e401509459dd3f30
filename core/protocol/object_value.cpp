// SPDX-License-Identifier: Apache-2.0
#include "protocol/object_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>
#include <optional>

#include "protocol/coe_data_type.h"
#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

using coe::DataType;
using coe::ValueKind;
constexpr std::string_view kBytes = "BYTES";  // no type of CoE: whatever there is

/// Of a value of this type; 0: any.
std::size_t size_of(const DataType& type) { return (type.bits + 7U) / 8U; }

std::uint64_t little_endian(std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
  return value;
}

std::vector<std::uint8_t> first_bytes(std::uint64_t value, std::size_t size) {
  const auto bytes = le_bytes(value);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
}

template <class T>
std::optional<T> number(std::string_view text, int base = 10) {
  T value{};
  const auto* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value, base);
  if (error != std::errc{} || stopped != end || text.empty()) return std::nullopt;
  return value;
}

template <class T>
std::optional<T> real_number(std::string_view text) {
  T value{};
  const auto* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end || text.empty()) return std::nullopt;
  return value;
}

std::string_view without_0x(std::string_view text) {
  const bool prefixed = text.starts_with("0x") || text.starts_with("0X");
  return prefixed ? text.substr(2) : text;
}

std::optional<std::vector<std::uint8_t>> integer_bytes(const DataType& type, std::string_view text) {
  const auto digits = without_0x(text);
  const auto unsigned_value = number<std::uint64_t>(digits, digits.size() == text.size() ? 10 : 16);
  const auto size = size_of(type);
  const auto bits = 8 * size;
  // Hexadecimal digits are bits: 0xFFFF is a fine INT.
  const auto value_bits = type.kind == ValueKind::kSigned && digits.size() == text.size() ? bits - 1 : bits;
  if (unsigned_value && (value_bits == 64 || *unsigned_value >> value_bits == 0))
    return first_bytes(*unsigned_value, size);
  const auto signed_value = number<std::int64_t>(text);
  if (type.kind != ValueKind::kSigned || !signed_value || *signed_value >= 0) return std::nullopt;
  const auto least = bits == 64 ? std::numeric_limits<std::int64_t>::min() : -(std::int64_t{1} << (bits - 1));
  if (*signed_value < least) return std::nullopt;
  return first_bytes(static_cast<std::uint64_t>(*signed_value), size);
}

std::optional<std::vector<std::uint8_t>> real_bytes(const DataType& type, std::string_view text) {
  if (size_of(type) == sizeof(float)) {
    const auto value = real_number<float>(text);
    return value ? std::optional(first_bytes(std::bit_cast<std::uint32_t>(*value), sizeof(float))) : std::nullopt;
  }
  const auto value = real_number<double>(text);
  return value ? std::optional(first_bytes(std::bit_cast<std::uint64_t>(*value), sizeof(double))) : std::nullopt;
}

std::optional<std::vector<std::uint8_t>> raw_bytes(std::string_view text) {
  std::string digits;
  std::ranges::copy_if(without_0x(text), std::back_inserter(digits), [](char c) { return c != ' '; });
  if (digits.size() % 2 != 0) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const auto byte = number<std::uint8_t>(std::string_view(digits).substr(i, 2), 16);
    if (!byte) return std::nullopt;
    bytes.push_back(*byte);
  }
  return bytes;
}

std::string text_of(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const auto byte : bytes) {
    if (byte == 0) break;
    text += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '?';
  }
  return text;
}

}  // namespace

Result<std::uint16_t> data_type_code(std::string_view name) {
  if (name == kBytes) return kBytesType;
  if (const auto* type = coe::find_data_type(name); type != nullptr && type->code != 0) return type->code;
  std::vector<std::string_view> names{kBytes};
  for (const auto& type : coe::data_types()) {
    if (type.code != 0) names.push_back(type.name);
  }
  return fail(ErrorCode::kBadValue, "--type", because("\"{text}\" is none of {words}", name, fmt::join(names, ", ")));
}

std::string data_type_name(std::uint16_t code) {
  if (code == kBytesType) return std::string(kBytes);
  const auto* type = coe::find_data_type(code);
  return type != nullptr ? std::string(type->name) : fmt::format("0x{:04X}", code);
}

std::string value_text(std::uint16_t code, std::span<const std::uint8_t> bytes) {
  const auto* type = coe::find_data_type(code);
  const bool fits = type != nullptr && (type->bits == 0 || size_of(*type) == bytes.size());
  if (!fits) return fmt::format("{:02x}", fmt::join(bytes.begin(), bytes.end(), " "));
  switch (type->kind) {
    case ValueKind::kUnsigned:
      return fmt::format("{}", little_endian(bytes));
    case ValueKind::kSigned: {
      const auto shift = 64 - 8 * static_cast<int>(bytes.size());
      return fmt::format("{}", static_cast<std::int64_t>(little_endian(bytes) << shift) >> shift);
    }
    case ValueKind::kReal:
      if (bytes.size() == sizeof(float)) return fmt::format("{}", std::bit_cast<float>(load_le<std::uint32_t>(bytes)));
      return fmt::format("{}", std::bit_cast<double>(little_endian(bytes)));
    case ValueKind::kText:
      break;
  }
  return text_of(bytes);
}

Result<std::vector<std::uint8_t>> value_bytes(std::uint16_t code, std::string_view text) {
  std::optional<std::vector<std::uint8_t>> bytes;
  if (const auto* type = coe::find_data_type(code); type == nullptr) {
    bytes = raw_bytes(text);
  } else if (type->kind == ValueKind::kText) {
    bytes.emplace(text.begin(), text.end());
  } else {
    bytes = type->kind == ValueKind::kReal ? real_bytes(*type, text) : integer_bytes(*type, text);
  }
  if (bytes && !bytes->empty()) return *bytes;
  return fail(ErrorCode::kBadValue, "VALUE", because("\"{text}\" is no {type}", text, data_type_name(code)));
}

Result<ObjectName> object_name(std::string_view text) {
  const auto colon = text.find(':');
  const auto index = number<std::uint16_t>(without_0x(text.substr(0, colon)), 16);
  ObjectName name;
  name.has_sub_index = colon != std::string_view::npos;
  const auto sub = name.has_sub_index ? number<std::uint8_t>(without_0x(text.substr(colon + 1)), 16) : std::uint8_t{0};
  if (!index || !sub) {
    return fail(ErrorCode::kBadValue, "INDEX", because("\"{text}\" is no object; write 0x1018:01", text));
  }
  name.index = *index;
  name.sub_index = *sub;
  return name;
}

}  // namespace syncline
