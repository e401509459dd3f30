// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "support/result.h"
#include "support/types.h"

/// What a setting holds. Text forms, checks, documentation and editors follow from its type alone.
namespace syncline::settings {

/// Nothing is set: something else decides ("auto", "none").
using Unset = std::monostate;

/// Number and Choice: std::int64_t (a choice of words may hold a std::string); Switch: bool; Text and Record:
/// std::string; Bytes: bytes; Indices: PDO indices.
using Value =
    std::variant<Unset, bool, std::int64_t, std::string, std::vector<std::uint8_t>, std::vector<std::uint16_t>>;

/// Both ends belong to it.
struct Range {
  std::int64_t low = 0, high = 0;
  [[nodiscard]] bool contains(std::int64_t value) const { return value >= low && value <= high; }
  bool operator==(const Range&) const = default;
};

struct Switch {};

/// Whole number, or nanoseconds shown as microseconds.
struct Number {
  Range range;
  std::string_view unit{};         // "ms", "frames"; "us" for a time in nanoseconds
  bool nanoseconds_as_us = false;  // then with three digits behind the point
  int hex_digits = 0;              // above 0: hexadecimal with so many
  bool without_zero = false;
};
[[nodiscard]] constexpr Number microseconds(Nanoseconds low, Nanoseconds high) {
  return {.range = {low, high}, .unit = "us", .nanoseconds_as_us = true};
}
[[nodiscard]] constexpr Number integer(std::int64_t low, std::int64_t high, std::string_view unit = {}) {
  return {.range = {low, high}, .unit = unit};
}

struct Option {
  Value value;
  std::string word;  // in text forms
  std::string text;  // for people; empty: the word
};
struct Choice {
  std::vector<Option> options;  // empty: see Setting::options
  std::string_view unit{};      // of numbers among which one is chosen
};

/// Printable UTF-8.
struct Text {
  std::string_view kind = "name";  // "IPv4 address"
  std::string_view form{};         // words for its range; empty: by length
  std::int64_t most_bytes = 255;
  bool may_be_empty = false;
  bool (*fits)(std::string_view) = nullptr;  // beside length and characters
  std::string_view example{};                // of what fits
};

/// Six bytes with colons.
struct MacAddress {};

/// PDO indices in the order of the process data.
struct Indices {};

/// Several values with a grammar of its own, as one text or packed into a number.
struct Record {
  std::string_view kind;     // "start-up command"
  std::string_view grammar;  // "NAME xMULTIPLE ..."
  bool packed = false;
};

using Type = std::variant<Switch, Number, Choice, Text, MacAddress, Indices, Record>;

[[nodiscard]] std::string type_text(const Type& type);
[[nodiscard]] std::string range_text(const Type& type);
/// parse_value(type, format_value(type, x)) is x.
[[nodiscard]] std::string format_value(const Type& type, const Value& value);
/// kBadValue with what is wrong and what is allowed, without a subject.
[[nodiscard]] Result<Value> parse_value(const Type& type, std::string_view text);
/// kBadValue when a value of the right kind is outside the type's range.
[[nodiscard]] Status check_value(const Type& type, const Value& value);
/// "1000 us is outside 0..500 us"
[[nodiscard]] Reason outside(const Number& number, std::int64_t value, const Range& range);
/// "0..500", in the number's unit.
[[nodiscard]] std::string range_text(const Number& number, const Range& range);

inline tl::unexpected<Error> bad_value(Reason detail) { return fail(ErrorCode::kBadValue, {}, std::move(detail)); }

}  // namespace syncline::settings
