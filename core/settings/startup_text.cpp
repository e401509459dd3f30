// SPDX-License-Identifier: Apache-2.0
#include "settings/startup_text.h"

#include <fmt/format.h>

#include "reasons/because.h"
#include "settings/number_text.h"
#include "settings/setting_type.h"
#include "support/utf8.h"

namespace syncline::settings {
namespace {}  // namespace

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

std::string format_transitions(const std::vector<Transition>& transitions) {
  std::string text;
  for (const auto transition : transitions) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", transition_name(transition));
  }
  return text;
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

namespace {

Status parse_object(std::string_view text, StartupCommand& command) {
  const auto colon = text.find(':');
  const auto equals = text.find('=');
  if (colon == std::string_view::npos || equals == std::string_view::npos || colon > equals) {
    return bad_value(because("\"{text}\" is no INDEX:SUB=DATA like 0x6060:00=08", text));
  }
  const auto index = parse_integer(text.substr(0, colon));
  const auto sub = parse_integer("0x" + std::string(text.substr(colon + 1, equals - colon - 1)));
  if (!index || *index < 1 || *index > 0xFFFF || !sub || *sub < 0 || *sub > 0xFF) {
    return bad_value(because("\"{text}\" is no object", text.substr(0, equals)));
  }
  auto data = parse_hex_data(text.substr(equals + 1));
  if (!data) return tl::unexpected(data.error());
  command.data = std::move(*data);
  command.index = static_cast<std::uint16_t>(*index);
  command.sub_index = static_cast<std::uint8_t>(*sub);
  return {};
}

Status parse_option(std::string_view word, StartupCommand& command) {
  constexpr std::string_view kTimeout = "timeout=";
  if (word == "complete") {
    command.complete_access = true;
  } else if (word == "fixed") {
    command.fixed = true;
  } else if (word == "off") {
    command.enabled = false;
  } else if (word == "adapt") {
    command.adapt_automatically = true;
  } else if (const auto ms = parse_integer(word.substr(std::min(kTimeout.size(), word.size())));
             word.starts_with(kTimeout) && ms && *ms >= 0 && *ms <= 0xFFFF'FFFF) {
    command.timeout_ms = static_cast<std::uint32_t>(*ms);
  } else {
    return bad_value(because("\"{text}\" is none of complete, fixed, off, adapt, timeout=MS", word));
  }
  return {};
}

}  // namespace

std::string format_startup(const StartupCommand& command) {
  std::string text = format_transitions(command.transitions);
  text += fmt::format(" 0x{:04x}:{:02x}={:02x}", command.index, command.sub_index, fmt::join(command.data, ""));
  if (command.complete_access) text += " complete";
  if (command.fixed) text += " fixed";
  if (!command.enabled) text += " off";
  if (command.adapt_automatically) text += " adapt";
  if (command.timeout_ms != 0) text += fmt::format(" timeout={}", command.timeout_ms);
  if (!command.comment.empty()) text.append(kCommentMark).append(command.comment);
  return text;
}

Result<StartupCommand> parse_startup(std::string_view text) {
  StartupCommand command;
  const auto mark = text.find(kCommentMark);
  if (mark != std::string_view::npos) command.comment = text.substr(mark + kCommentMark.size());
  if (!is_utf8(command.comment)) return bad_value(because("the comment is no UTF-8 text"));
  auto rest = text.substr(0, mark);
  if (auto status = parse_transitions(next_word(rest), command.transitions); !status)
    return tl::unexpected(status.error());
  if (auto status = parse_object(next_word(rest), command); !status) return tl::unexpected(status.error());
  for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
    if (auto status = parse_option(word, command); !status) return tl::unexpected(status.error());
  }
  return command;
}

}  // namespace syncline::settings
