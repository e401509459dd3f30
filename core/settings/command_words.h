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
/// "PS,SP" as transitions_text() writes them.
[[nodiscard]] Status parse_transitions(std::string_view text, std::vector<Transition>& transitions);
/// Bytes in wire order, two digits each.
[[nodiscard]] Result<std::vector<std::uint8_t>> parse_hex_data(std::string_view digits);
/// 0 to 2^32 - 1.
[[nodiscard]] std::optional<std::uint32_t> parse_milliseconds(std::string_view text);

/// The comment is everything behind " # ".
[[nodiscard]] std::string format_comment(const std::string& comment);
/// The comment goes into `comment`; what stands before it is left. kBadValue for what is no UTF-8.
[[nodiscard]] Result<std::string_view> take_comment(std::string_view text, std::string& comment);

/// The error of a word that is none of the usual options.
[[nodiscard]] Status no_usual_option(std::string_view word);

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

/// An option of a command that has the usual ones only; kBadValue where the word is none of them.
template <class Command>
[[nodiscard]] Status parse_usual_option(std::string_view word, Command& command) {
  return take_usual_option(word, command) ? Status{} : no_usual_option(word);
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

/// Reads "TRANSITIONS WHAT OPTIONS # comment", which is the form of all commands. `what` takes what is sent off the
/// front of the text, `option` one word behind it; both give a Status. kBadValue with what is wrong in it.
template <class Command, class What, class Option>
[[nodiscard]] Result<Command> parse_command(std::string_view text, What what, Option option) {
  Command command;
  auto rest = take_comment(text, command.comment);
  if (!rest) return tl::unexpected(rest.error());
  auto status = parse_transitions(next_word(*rest), command.transitions);
  if (status) status = what(*rest, command);
  for (auto word = next_word(*rest); status && !word.empty(); word = next_word(*rest)) status = option(word, command);
  if (!status) return tl::unexpected(status.error());
  return command;
}

}  // namespace syncline::settings
