// SPDX-License-Identifier: Apache-2.0
#include "settings/setting_type.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "reasons/because.h"
#include "settings/number_text.h"
#include "support/utf8.h"

namespace syncline::settings {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

constexpr std::size_t kMacBytes = 6;

std::string number_text(const Number& number, std::int64_t value) {
  if (number.nanoseconds_as_us) return format_microseconds(value);
  if (number.hex_digits > 0) return fmt::format("0x{:0{}x}", value, number.hex_digits);
  return fmt::format("{}", value);
}

std::string words(const Choice& choice) {
  std::string text;
  for (const Option& option : choice.options) text += (text.empty() ? "" : ", ") + option.word;
  return text;
}

std::string byte_range(const Text& text) {
  if (!text.form.empty()) return std::string(text.form);
  return fmt::format("{}1..{} bytes of text", text.may_be_empty ? "nothing, " : "", text.most_bytes);
}

Result<Value> parse_number(const Number& number, std::string_view text) {
  const auto value = number.nanoseconds_as_us ? parse_microseconds(text) : parse_integer(text);
  if (value) return Value{*value};
  if (!number.nanoseconds_as_us) return bad_value(because("\"{text}\" is no whole number", text));
  return bad_value(because("\"{text}\" is no number of microseconds with at most three decimals", text));
}

Result<Value> parse_switch(std::string_view text) {
  if (text == "on" || text == "true" || text == "1") return Value{true};
  if (text == "off" || text == "false" || text == "0") return Value{false};
  return bad_value(because("\"{text}\" is neither on nor off", text));
}

Result<Value> parse_choice(const Choice& choice, std::string_view text) {
  const auto number = parse_integer(text);
  for (const Option& option : choice.options) {
    if (option.word == text || (number && parse_integer(option.word) == number)) return option.value;
  }
  return bad_value(because("\"{text}\" is none of {words}", text, words(choice)));
}

Result<Value> parse_mac(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  bool ok = text.size() == 3 * kMacBytes - 1;
  for (std::size_t i = 0; ok && i < kMacBytes; ++i) {
    const auto byte = parse_hex_byte(text.substr(3 * i, 2));
    ok = byte && (i == 0 || text[3 * i - 1] == ':');
    bytes.push_back(byte.value_or(0));
  }
  if (!ok) return bad_value(because("\"{text}\" is no address like 01:23:45:67:89:ab", text));
  return Value{std::move(bytes)};
}

Result<Value> parse_indices(std::string_view text) {
  std::vector<std::uint16_t> indices;
  while (!text.empty()) {
    const auto comma = text.find(',');
    const auto part = text.substr(0, comma);
    const auto index = parse_integer(part);
    const bool cut = comma != std::string_view::npos && comma + 1 == text.size();
    if (!index || *index < 0 || *index > 0xFFFF || cut) {
      return bad_value(because("\"{text}\" is no PDO index", cut && index ? "" : part));
    }
    indices.push_back(static_cast<std::uint16_t>(*index));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  return Value{std::move(indices)};
}

Status check_text(const Text& type, const std::string& text) {
  if (text.empty()) return type.may_be_empty ? Status{} : Status(bad_value(because("a name cannot be empty")));
  const bool control =
      std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  if (std::cmp_greater(text.size(), type.most_bytes)) {
    return bad_value(
        because("a {kind} has at most {bytes} bytes", type.kind == "text" ? "name" : type.kind, type.most_bytes));
  }
  if (type.fits != nullptr && !type.fits(text)) {
    return bad_value(because("\"{text}\" is no address like {example}", text, type.example));
  }
  if (control || !is_utf8(text)) return bad_value(because("a name is printable UTF-8 text"));
  return {};
}

Status check_number(const Number& number, std::int64_t value) {
  if (!number.range.contains(value)) return bad_value(outside(number, value, number.range));
  if (number.without_zero && value == 0)
    return bad_value(because("the factor 0 gives no cycle; switch the operation mode off instead"));
  return {};
}

}  // namespace

std::string range_text(const Number& number, const Range& range) {
  if (number.without_zero) return fmt::format("{}..-1, 1..{}", range.low, range.high);
  return fmt::format("{}..{}", number_text(number, range.low), number_text(number, range.high));
}

Reason outside(const Number& number, std::int64_t value, const Range& range) {
  const std::string unit = number.unit.empty() ? "" : fmt::format(" {}", number.unit);
  return because("{value} is outside {range}", number_text(number, value) + unit, range_text(number, range) + unit);
}

std::string type_text(const Type& type) {
  return std::visit(
      Overloaded{
          [](const Switch&) -> std::string { return "switch"; },
          [](const Number& number) -> std::string {
            if (number.nanoseconds_as_us) return "number us, to 0.001";
            return number.unit.empty() ? "integer" : fmt::format("integer {}", number.unit);
          },
          [](const Choice& c) { return c.unit.empty() ? std::string("choice") : fmt::format("integer {}", c.unit); },
          [](const Text& text) { return std::string(text.kind == "host name" ? "text" : text.kind); },
          [](const MacAddress&) -> std::string { return "Ethernet address"; },
          [](const Indices&) -> std::string { return "list of PDO indices"; },
          [](const Record& record) { return std::string(record.kind); }},
      type);
}

std::string range_text(const Type& type) {
  return std::visit(
      Overloaded{[](const Switch&) -> std::string { return "on, off"; },
                 [](const Number& number) { return range_text(number, number.range); },
                 [](const Choice& choice) { return words(choice); }, [](const Text& text) { return byte_range(text); },
                 [](const MacAddress&) -> std::string { return "six hexadecimal bytes with colons"; },
                 [](const Indices&) -> std::string { return "indices of the device with commas, or nothing"; },
                 [](const Record& record) { return std::string(record.grammar); }},
      type);
}

std::string format_value(const Type& type, const Value& value) {
  if (const auto* choice = std::get_if<Choice>(&type)) {
    const auto option = std::ranges::find(choice->options, value, &Option::value);
    if (option != choice->options.end()) return option->word;
  }
  return std::visit(
      Overloaded{[](Unset) -> std::string { return {}; }, [](bool on) -> std::string { return on ? "on" : "off"; },
                 [&](std::int64_t x) {
                   const auto* number = std::get_if<Number>(&type);
                   return number != nullptr ? number_text(*number, x) : fmt::format("{}", x);
                 },
                 [](const std::string& text) { return text; },
                 [](const std::vector<std::uint8_t>& b) { return fmt::format("{:02x}", fmt::join(b, ":")); },
                 [](const std::vector<std::uint16_t>& indices) {
                   std::string text;
                   for (const auto i : indices) text += fmt::format("{}0x{:04x}", text.empty() ? "" : ",", i);
                   return text;
                 }},
      value);
}

Result<Value> parse_value(const Type& type, std::string_view text) {
  auto value = std::visit(Overloaded{[&](const Switch&) { return parse_switch(text); },
                                     [&](const Number& number) { return parse_number(number, text); },
                                     [&](const Choice& choice) { return parse_choice(choice, text); },
                                     [&](const Text&) { return Result<Value>(std::string(text)); },
                                     [&](const MacAddress&) { return parse_mac(text); },
                                     [&](const Indices&) { return parse_indices(text); },
                                     [&](const Record&) { return Result<Value>(std::string(text)); }},
                          type);
  if (value) {
    if (auto status = check_value(type, *value); !status) return tl::unexpected(status.error());
  }
  return value;
}

Status check_value(const Type& type, const Value& value) {
  if (const auto* number = std::get_if<Number>(&type)) {
    if (const auto* x = std::get_if<std::int64_t>(&value)) return check_number(*number, *x);
    return bad_value(because("it is a number"));
  }
  if (const auto* text = std::get_if<Text>(&type)) {
    if (const auto* words_of = std::get_if<std::string>(&value)) return check_text(*text, *words_of);
    return bad_value(because("it is a text"));
  }
  if (const auto* choice = std::get_if<Choice>(&type)) {
    const bool known =
        choice->options.empty() || std::ranges::find(choice->options, value, &Option::value) != choice->options.end();
    return known ? Status{}
                 : Status(bad_value(because("{value} is none of {words}", format_value(type, value), words(*choice))));
  }
  const auto* record = std::get_if<Record>(&type);
  const bool fits =
      (std::holds_alternative<Switch>(type) && std::holds_alternative<bool>(value)) ||
      (record != nullptr &&
       (record->packed ? std::holds_alternative<std::int64_t>(value) : std::holds_alternative<std::string>(value))) ||
      (std::holds_alternative<Indices>(type) && std::holds_alternative<std::vector<std::uint16_t>>(value)) ||
      (std::holds_alternative<MacAddress>(type) && std::holds_alternative<std::vector<std::uint8_t>>(value) &&
       std::get<std::vector<std::uint8_t>>(value).size() == kMacBytes);
  return fits ? Status{} : Status(bad_value(because("the value is of another kind")));
}

}  // namespace syncline::settings
