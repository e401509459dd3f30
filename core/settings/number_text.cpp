// SPDX-License-Identifier: Apache-2.0
#include "settings/number_text.h"

#include <fmt/format.h>

#include <charconv>

namespace syncline::settings {
namespace {

template <class T>
bool read_all(std::string_view text, T& value, int base = 10) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::optional<std::int64_t> parse_integer(std::string_view text) {
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  if (is_hex) text.remove_prefix(2);
  if (is_hex && text.starts_with('-')) return std::nullopt;
  std::int64_t value = 0;
  return read_all(text, value, is_hex ? 16 : 10) ? std::optional(value) : std::nullopt;
}

std::optional<std::uint8_t> parse_hex_byte(std::string_view two_digits) {
  std::uint8_t value = 0;
  return read_all(two_digits, value, 16) ? std::optional(value) : std::nullopt;
}

std::optional<Nanoseconds> parse_microseconds(std::string_view text) {
  constexpr std::int64_t kLargest = 1'000'000'000'000;  // far beyond every range, far below an overflow
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const auto point = text.find('.');
  const auto whole_text = text.substr(0, point);
  auto fraction_text = point == std::string_view::npos ? std::string{} : std::string(text.substr(point + 1));
  if (point != std::string_view::npos && (fraction_text.empty() || fraction_text.size() > 3)) return std::nullopt;
  fraction_text.resize(3, '0');
  std::uint64_t whole = 0;
  std::uint32_t fraction = 0;
  if (!read_all(whole_text, whole) || !read_all(std::string_view(fraction_text), fraction) || whole > kLargest) {
    return std::nullopt;
  }
  const auto value = static_cast<Nanoseconds>(whole) * kMicrosecond + fraction;
  return negative ? -value : value;
}

std::string format_microseconds(Nanoseconds value) {
  const bool negative = value < 0;
  const auto magnitude = negative ? 0U - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  auto text = fmt::format("{}{}", negative ? "-" : "", magnitude / 1000);
  if (magnitude % 1000 == 0) return text;
  text += fmt::format(".{:03}", magnitude % 1000);
  text.erase(text.find_last_not_of('0') + 1);
  return text;
}

}  // namespace syncline::settings
