// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/al_state.h"
#include "support/result.h"

/// Parts of the text of a command that is sent at state transitions: transitions, data, options, comment.
namespace syncline::settings {

/// Takes the next word off the front of `text`; "" at its end.
[[nodiscard]] std::string_view next_word(std::string_view& text);
/// What stands behind `name` in `word`; nothing where another word stands there.
[[nodiscard]] std::optional<std::string_view> value_of(std::string_view word, std::string_view name);
[[nodiscard]] std::string format_transitions(const std::vector<Transition>& transitions);
[[nodiscard]] Status parse_transitions(std::string_view text, std::vector<Transition>& transitions);
/// Bytes in wire order, two digits each.
[[nodiscard]] Result<std::vector<std::uint8_t>> parse_hex_data(std::string_view digits);
/// 0 to 2^32 - 1.
[[nodiscard]] std::optional<std::uint32_t> parse_milliseconds(std::string_view text);

/// The comment is everything behind " # ".
[[nodiscard]] std::string format_comment(const std::string& comment);
/// The comment goes into `comment`; what stands before it is left. kBadValue for what is no UTF-8.
[[nodiscard]] Result<std::string_view> take_comment(std::string_view text, std::string& comment);

inline constexpr std::string_view kTimeoutWord = "timeout=";

/// "fixed", "off" and "timeout=MS", which start-up messages of all protocols have; false: the word is none of them.
template <class Command>
[[nodiscard]] bool take_usual_option(std::string_view word, Command& command) {
  const auto timeout = value_of(word, kTimeoutWord);
  const auto ms = timeout ? parse_milliseconds(*timeout) : std::nullopt;
  if (word == "fixed") {
    command.fixed = true;
  } else if (word == "off") {
    command.enabled = false;
  } else if (ms) {
    command.timeout_ms = *ms;
  } else {
    return false;
  }
  return true;
}

/// Those of them that are set, each behind a space; `between`: stands before the time-out.
template <class Command>
[[nodiscard]] std::string format_usual_options(const Command& command, std::string_view between = "") {
  std::string text;
  if (command.fixed) text += " fixed";
  if (!command.enabled) text += " off";
  text += between;
  if (command.timeout_ms != 0) text.append(" ").append(kTimeoutWord).append(std::to_string(command.timeout_ms));
  return text;
}

}  // namespace syncline::settings
