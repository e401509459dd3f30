// SPDX-License-Identifier: Apache-2.0
#include "settings/startup_text.h"

#include <fmt/format.h>

#include "config/command_text.h"
#include "reasons/because.h"
#include "settings/command_words.h"
#include "settings/number_text.h"
#include "settings/setting_type.h"

namespace syncline::settings {
namespace {

Status parse_object(std::string_view& rest, StartupCommand& command) {
  const auto text = next_word(rest);
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
  if (take_usual_option(word, command)) return {};
  if (word == "complete") {
    command.complete_access = true;
  } else if (word == "adapt") {
    command.adapt_automatically = true;
  } else {
    return bad_value(because("\"{text}\" is none of complete, fixed, off, adapt, timeout=MS", word));
  }
  return {};
}

}  // namespace

std::string format_startup(const StartupCommand& command) {
  std::string text = transitions_text(command.transitions);
  text += fmt::format(" 0x{:04x}:{:02x}={:02x}", command.index, command.sub_index, fmt::join(command.data, ""));
  if (command.complete_access) text += " complete";
  text += format_usual_options(command, command.adapt_automatically ? " adapt" : "");
  return text + format_comment(command.comment);
}

Result<StartupCommand> parse_startup(std::string_view text) {
  return parse_command<StartupCommand>(text, parse_object, parse_option);
}

}  // namespace syncline::settings
