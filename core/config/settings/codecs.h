// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "config/settings/setting_rule.h"
#include "support/types.h"

/// Text forms of values. A codec has type() and range() for the explanation, format() and parse() for the value, and
/// parse(format(x)) is x.
namespace syncline::settings {

/// Decimal or 0x hexadecimal, nothing around it.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);
/// "62.5" us is 62500 ns; at most three digits behind the point.
[[nodiscard]] std::optional<Nanoseconds> parse_microseconds(std::string_view text);
[[nodiscard]] std::string format_microseconds(Nanoseconds value);

template <std::integral T>
struct IntegerCodec {
  using Value = T;
  std::int64_t min = 0;
  std::int64_t max = std::numeric_limits<T>::max();
  const char* unit = "";

  [[nodiscard]] std::string type() const { return *unit == '\0' ? "integer" : fmt::format("integer {}", unit); }
  [[nodiscard]] std::string range() const { return fmt::format("{}..{}", min, max); }
  [[nodiscard]] std::string format(T value) const { return fmt::format("{}", value); }
  [[nodiscard]] Result<T> parse(std::string_view text) const {
    const auto value = parse_integer(text);
    if (!value) return bad_value(fmt::format("\"{}\" is no whole number", text));
    if (*value < min || *value > max) return bad_value(fmt::format("{} is outside {}", text, range()));
    return static_cast<T>(*value);
  }
};

/// Nanoseconds as microseconds.
struct MicrosecondCodec {
  using Value = Nanoseconds;
  Nanoseconds min = 0;
  Nanoseconds max = 0;

  [[nodiscard]] std::string type() const { return "number us, to 0.001"; }
  [[nodiscard]] std::string range() const {
    return fmt::format("{}..{}", format_microseconds(min), format_microseconds(max));
  }
  [[nodiscard]] std::string format(Nanoseconds value) const { return format_microseconds(value); }
  [[nodiscard]] Result<Nanoseconds> parse(std::string_view text) const;
};

struct SwitchCodec {
  using Value = bool;
  [[nodiscard]] std::string type() const { return "switch"; }
  [[nodiscard]] std::string range() const { return "on, off"; }
  [[nodiscard]] std::string format(bool value) const { return value ? "on" : "off"; }
  [[nodiscard]] Result<bool> parse(std::string_view text) const;
};

/// Printable UTF-8, not empty.
struct NameCodec {
  using Value = std::string;
  [[nodiscard]] std::string type() const { return "name"; }
  [[nodiscard]] std::string range() const { return "1..255 bytes of text"; }
  [[nodiscard]] std::string format(const std::string& value) const { return value; }
  [[nodiscard]] Result<std::string> parse(std::string_view text) const;
};

struct DcmModeCodec {
  using Value = DcmMode;
  [[nodiscard]] std::string type() const { return "choice"; }
  [[nodiscard]] std::string range() const { return "off, bus-shift, master-shift, master-ref-clock, link-layer-ref-clock, dcx, master-shift-by-app"; }
  [[nodiscard]] std::string format(DcmMode value) const { return std::string(dcm_mode_name(value)); }
  [[nodiscard]] Result<DcmMode> parse(std::string_view text) const;
};

struct MacCodec {
  using Value = std::array<std::uint8_t, 6>;
  [[nodiscard]] std::string type() const { return "Ethernet address"; }
  [[nodiscard]] std::string range() const { return "six hexadecimal bytes with colons"; }
  [[nodiscard]] std::string format(const Value& value) const;
  [[nodiscard]] Result<Value> parse(std::string_view text) const;
};

/// Like NameCodec, but may be empty.
struct TextCodec {
  using Value = std::string;
  [[nodiscard]] std::string type() const { return "text"; }
  [[nodiscard]] std::string range() const { return "nothing, 1..255 bytes of text"; }
  [[nodiscard]] std::string format(const std::string& value) const { return value; }
  [[nodiscard]] Result<std::string> parse(std::string_view text) const {
    return text.empty() ? Result<std::string>{} : NameCodec{}.parse(text);
  }
};

/// "auto" for an empty optional: something else decides (the operation mode, the master). Or another word.
template <class Codec>
struct AutoCodec {
  using Value = std::optional<typename Codec::Value>;
  Codec codec{};
  const char* word = "auto";
  [[nodiscard]] std::string type() const { return codec.type(); }
  [[nodiscard]] std::string range() const { return std::string(word) + ", " + codec.range(); }
  [[nodiscard]] std::string format(const Value& value) const { return value ? codec.format(*value) : word; }
  [[nodiscard]] Result<Value> parse(std::string_view text) const {
    if (text == word) return Value{};
    auto value = codec.parse(text);
    if (!value) return tl::unexpected(value.error());
    return Value{std::move(*value)};
  }
};

/// Rule of a field that only its codec checks. `field(project, place)` gives the field of a const or mutable project.
template <class Codec, class Field>
[[nodiscard]] Rule field_rule(std::string key, std::string meaning, Codec codec, Field field) {
  Rule rule{.key = std::move(key), .type = codec.type(), .range = codec.range(), .meaning = std::move(meaning),
            .get = {}, .set = {}};
  rule.get = [codec, field](const Project& project, const Place& place) { return codec.format(field(project, place)); };
  rule.set = [codec, field](Project& project, const Place& place, std::string_view text) -> Status {
    auto value = codec.parse(text);
    if (!value) return tl::unexpected(value.error());
    field(project, place) = std::move(*value);
    return {};
  };
  return rule;
}

}  // namespace syncline::settings
