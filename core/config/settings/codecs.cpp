// SPDX-License-Identifier: Apache-2.0
#include "config/settings/codecs.h"

#include <algorithm>
#include <charconv>

#include "support/utf8.h"

namespace syncline::settings {
namespace {

constexpr std::size_t kNameBytes = 255;

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

Result<Nanoseconds> MicrosecondCodec::parse(std::string_view text) const {
  const auto value = parse_microseconds(text);
  if (!value) return bad_value(fmt::format("\"{}\" is no number of microseconds with at most three decimals", text));
  if (*value < min || *value > max) return bad_value(fmt::format("{} us is outside {} us", text, range()));
  return *value;
}

Result<bool> SwitchCodec::parse(std::string_view text) const {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  return bad_value(fmt::format("\"{}\" is neither on nor off", text));
}

Result<std::string> NameCodec::parse(std::string_view text) const {
  const bool control = std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  if (text.empty()) return bad_value("a name cannot be empty");
  if (text.size() > kNameBytes) return bad_value(fmt::format("a name has at most {} bytes", kNameBytes));
  if (control || !is_utf8(text)) return bad_value("a name is printable UTF-8 text");
  return std::string(text);
}

Result<DcmMode> DcmModeCodec::parse(std::string_view text) const {
  if (const auto mode = dcm_mode_from_name(text)) return *mode;
  return bad_value(fmt::format("\"{}\" is none of {}", text, range()));
}

std::string MacCodec::format(const Value& value) const { return fmt::format("{:02x}", fmt::join(value, ":")); }

Result<MacCodec::Value> MacCodec::parse(std::string_view text) const {
  Value value{};
  bool ok = text.size() == 3 * value.size() - 1;
  for (std::size_t i = 0; ok && i < value.size(); ++i) {
    ok = read_all(text.substr(3 * i, 2), value[i], 16) && (i == 0 || text[3 * i - 1] == ':');
  }
  if (!ok) return bad_value(fmt::format("\"{}\" is no address like 01:23:45:67:89:ab", text));
  return value;
}

}  // namespace syncline::settings
