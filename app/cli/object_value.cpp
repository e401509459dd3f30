// SPDX-License-Identifier: Apache-2.0
#include "app/cli/object_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <optional>

#include "support/byte_order.h"

namespace syncline::cli {
namespace {

enum class Kind : std::uint8_t { kSigned, kUnsigned, kReal, kText, kBytes };
struct TypeRow {
  std::uint16_t code;
  std::string_view name;
  Kind kind;
  std::size_t size;  // bytes, 0: any
};
constexpr std::array kTypes = {
    TypeRow{0x0001, "BOOL", Kind::kUnsigned, 1},  TypeRow{0x0002, "SINT", Kind::kSigned, 1},
    TypeRow{0x0003, "INT", Kind::kSigned, 2},     TypeRow{0x0004, "DINT", Kind::kSigned, 4},
    TypeRow{0x0005, "USINT", Kind::kUnsigned, 1}, TypeRow{0x0006, "UINT", Kind::kUnsigned, 2},
    TypeRow{0x0007, "UDINT", Kind::kUnsigned, 4}, TypeRow{0x0008, "REAL", Kind::kReal, 4},
    TypeRow{kStringType, "STRING", Kind::kText, 0}, TypeRow{0x0011, "LREAL", Kind::kReal, 8},
    TypeRow{0x0015, "LINT", Kind::kSigned, 8},    TypeRow{0x001B, "ULINT", Kind::kUnsigned, 8},
    TypeRow{0x001E, "BYTE", Kind::kUnsigned, 1},  TypeRow{0x001F, "WORD", Kind::kUnsigned, 2},
    TypeRow{0x0020, "DWORD", Kind::kUnsigned, 4}, TypeRow{kBytesType, "BYTES", Kind::kBytes, 0},
};

const TypeRow* row_of(std::uint16_t code) {
  const auto found = std::ranges::find(kTypes, code, &TypeRow::code);
  return found == kTypes.end() ? nullptr : &*found;
}

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

std::optional<std::vector<std::uint8_t>> integer_bytes(const TypeRow& type, std::string_view text) {
  const auto digits = without_0x(text);
  const auto unsigned_value = number<std::uint64_t>(digits, digits.size() == text.size() ? 10 : 16);
  const auto bits = 8 * type.size;
  // Hexadecimal digits are bits: 0xFFFF is a fine INT.
  const auto value_bits = type.kind == Kind::kSigned && digits.size() == text.size() ? bits - 1 : bits;
  if (unsigned_value && (value_bits == 64 || *unsigned_value >> value_bits == 0)) return first_bytes(*unsigned_value, type.size);
  const auto signed_value = number<std::int64_t>(text);
  if (type.kind != Kind::kSigned || !signed_value || *signed_value >= 0) return std::nullopt;
  const auto least = bits == 64 ? std::numeric_limits<std::int64_t>::min() : -(std::int64_t{1} << (bits - 1));
  if (*signed_value < least) return std::nullopt;
  return first_bytes(static_cast<std::uint64_t>(*signed_value), type.size);
}

std::optional<std::vector<std::uint8_t>> real_bytes(const TypeRow& type, std::string_view text) {
  if (type.size == sizeof(float)) {
    const auto value = real_number<float>(text);
    return value ? std::optional(first_bytes(std::bit_cast<std::uint32_t>(*value), type.size)) : std::nullopt;
  }
  const auto value = real_number<double>(text);
  return value ? std::optional(first_bytes(std::bit_cast<std::uint64_t>(*value), type.size)) : std::nullopt;
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
  const auto found = std::ranges::find(kTypes, name, &TypeRow::name);
  if (found != kTypes.end()) return found->code;
  std::vector<std::string_view> names;
  std::ranges::transform(kTypes, std::back_inserter(names), &TypeRow::name);
  return fail(ErrorCode::kBadValue, "--type", fmt::format("\"{}\" is none of {}", name, fmt::join(names, ", ")));
}

std::string data_type_name(std::uint16_t code) {
  const auto* type = row_of(code);
  return type != nullptr ? std::string(type->name) : fmt::format("0x{:04X}", code);
}

std::string value_text(std::uint16_t code, std::span<const std::uint8_t> bytes) {
  const auto* type = row_of(code);
  const bool fits = type != nullptr && (type->size == 0 || type->size == bytes.size());
  const auto kind = fits ? type->kind : Kind::kBytes;
  switch (kind) {
    case Kind::kUnsigned: return fmt::format("{}", little_endian(bytes));
    case Kind::kSigned: {
      const auto shift = 64 - 8 * static_cast<int>(bytes.size());
      return fmt::format("{}", static_cast<std::int64_t>(little_endian(bytes) << shift) >> shift);
    }
    case Kind::kReal:
      if (bytes.size() == sizeof(float)) return fmt::format("{}", std::bit_cast<float>(load_le<std::uint32_t>(bytes)));
      return fmt::format("{}", std::bit_cast<double>(little_endian(bytes)));
    case Kind::kText: return text_of(bytes);
    case Kind::kBytes: break;
  }
  return fmt::format("{:02x}", fmt::join(bytes.begin(), bytes.end(), " "));
}

Result<std::vector<std::uint8_t>> value_bytes(std::uint16_t code, std::string_view text) {
  const auto* type = row_of(code);
  const auto kind = type != nullptr ? type->kind : Kind::kBytes;
  std::optional<std::vector<std::uint8_t>> bytes;
  switch (kind) {
    case Kind::kSigned:
    case Kind::kUnsigned: bytes = integer_bytes(*type, text); break;
    case Kind::kReal: bytes = real_bytes(*type, text); break;
    case Kind::kText: bytes.emplace(text.begin(), text.end()); break;
    case Kind::kBytes: bytes = raw_bytes(text); break;
  }
  if (bytes && !bytes->empty()) return *bytes;
  return fail(ErrorCode::kBadValue, "VALUE", fmt::format("\"{}\" is no {}", text, data_type_name(code)));
}

Result<ObjectName> object_name(std::string_view text) {
  const auto colon = text.find(':');
  const auto index = number<std::uint16_t>(without_0x(text.substr(0, colon)), 16);
  ObjectName name;
  name.has_sub_index = colon != std::string_view::npos;
  const auto sub = name.has_sub_index ? number<std::uint8_t>(without_0x(text.substr(colon + 1)), 16) : std::uint8_t{0};
  if (!index || !sub) {
    return fail(ErrorCode::kBadValue, "INDEX", fmt::format("\"{}\" is no object; write 0x1018:01", text));
  }
  name.index = *index;
  name.sub_index = *sub;
  return name;
}

}  // namespace syncline::cli
