// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_number.h"

#include <fmt/format.h>

#include <charconv>

#include "eni/xml/xml_text.h"

namespace syncline::eni {
namespace {

std::optional<int> nibble(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

std::optional<std::int64_t> hexadecimal(std::string_view digits) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.empty() || digits.front() == '-' || error != std::errc{} || end != digits.data() + digits.size()) {
    return std::nullopt;
  }
  return value;
}

/// Digits, then a fraction of zeros or a unit.
std::optional<std::int64_t> with_tail(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view tail(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (tail.starts_with('.') && tail.find_first_not_of('0', 1) == std::string_view::npos) return value;
  const auto unit = trim(tail);
  return unit == "ms" || unit == "ns" || unit == "bit" || unit == "bits" ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<std::int64_t> parse_sloppy_number(std::string_view text) {
  std::string word;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n')
      word.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c);
  }
  if (const auto number = parse_number(word)) return number;
  const std::string_view view = word;
  for (const std::string_view prefix : {"#x0x", "0x0x", "16#", "&h", "#", "x", "$"}) {
    if (view.starts_with(prefix)) return hexadecimal(view.substr(prefix.size()));
  }
  if (view.ends_with('h')) return hexadecimal(view.substr(0, view.size() - 1));
  return with_tail(trim(text));
}

std::optional<std::int64_t> parse_number(std::string_view text) {
  text = trim(text);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const bool is_hex = text.size() > 2 && (text[0] == '#' || text[0] == '0') && (text[1] == 'x' || text[1] == 'X');
  if (is_hex) text.remove_prefix(2);
  if (text.empty() || text.front() == '-') return std::nullopt;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, is_hex ? 16 : 10);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return negative ? -value : value;
}

std::optional<bool> parse_bool(std::string_view text) {
  text = trim(text);
  if (text == "1" || text == "true" || text == "True" || text == "TRUE") return true;
  if (text == "0" || text == "false" || text == "False" || text == "FALSE") return false;
  return std::nullopt;
}

std::optional<std::vector<std::uint8_t>> parse_hex_bytes(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  int high = -1;  // not an optional: GCC 12 warns of it here
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    const auto digit = nibble(c);
    if (!digit) return std::nullopt;
    if (high >= 0) {
      bytes.push_back(static_cast<std::uint8_t>(high << 4 | *digit));
      high = -1;
    } else {
      high = *digit;
    }
  }
  if (high >= 0) return std::nullopt;
  return bytes;
}

std::string hex_bytes(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  out.reserve(bytes.size() * 2);
  for (const std::uint8_t byte : bytes) {
    out.push_back(kDigits[byte >> 4]);
    out.push_back(kDigits[byte & 0x0F]);
  }
  return out;
}

std::string hex_dec(std::uint64_t value, int digits) { return fmt::format("#x{:0{}x}", value, digits); }

}  // namespace syncline::eni
