// SPDX-License-Identifier: Apache-2.0
#include "settings/command_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "reasons/because.h"
#include "settings/number_text.h"
#include "settings/setting_type.h"
#include "support/utf8.h"

namespace syncline::settings {
namespace {

constexpr std::string_view kCommentMark = " # ";

}  // namespace

std::string_view next_word(std::string_view& text) {
  const auto begin = std::min(text.find_first_not_of(' '), text.size());
  const auto end = std::min(text.find(' ', begin), text.size());
  const auto word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

Status parse_transitions(std::string_view text, std::vector<Transition>& transitions) {
  transitions.clear();
  while (true) {
    const auto comma = text.find(',');
    const auto name = text.substr(0, comma);
    const auto transition = transition_from_name(name);
    if (!transition) return bad_value(because("\"{text}\" is no state transition like PS or SO", name));
    transitions.push_back(*transition);
    if (comma == std::string_view::npos) return {};
    text.remove_prefix(comma + 1);
  }
}

Result<std::vector<std::uint8_t>> parse_hex_data(std::string_view digits) {
  std::vector<std::uint8_t> data;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const auto byte = parse_integer("0x" + std::string(digits.substr(i, 2)));
    if (!byte || digits.size() % 2 != 0) return bad_value(because("\"{text}\" are no whole hexadecimal bytes", digits));
    data.push_back(static_cast<std::uint8_t>(*byte));
  }
  return data;
}

std::optional<std::string_view> value_of(std::string_view word, std::string_view name) {
  return word.starts_with(name) ? std::optional(word.substr(name.size())) : std::nullopt;
}

Status no_usual_option(std::string_view word) {
  return bad_value(because("\"{text}\" is none of fixed, off, timeout=MS", word));
}

std::optional<std::uint32_t> parse_milliseconds(std::string_view text) {
  const auto ms = parse_integer(text);
  return ms && *ms >= 0 && *ms <= 0xFFFF'FFFF ? std::optional(static_cast<std::uint32_t>(*ms)) : std::nullopt;
}

std::string format_comment(const std::string& comment) {
  return comment.empty() ? std::string() : std::string(kCommentMark) + comment;
}

Result<std::string_view> take_comment(std::string_view text, std::string& comment) {
  const auto mark = text.find(kCommentMark);
  if (mark != std::string_view::npos) comment = text.substr(mark + kCommentMark.size());
  if (!is_utf8(comment)) return bad_value(because("the comment is no UTF-8 text"));
  return text.substr(0, mark);
}

}  // namespace syncline::settings
