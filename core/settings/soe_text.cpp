// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "config/command_text.h"
#include "protocol/soe.h"
#include "reasons/because.h"
#include "settings/command_words.h"
#include "settings/number_text.h"
#include "settings/setting_type.h"
#include "settings/startup_text.h"

namespace syncline::settings {
namespace {

Status parse_target(std::string_view& rest, SoeCommand& command) {
  const auto text = next_word(rest);
  const auto colon = text.find(':');
  const auto equals = text.find('=');
  if (colon == std::string_view::npos || equals == std::string_view::npos || colon > equals) {
    return bad_value(because("\"{text}\" is no DRIVE:IDN=DATA like 0:S-0-0047=00000000", text));
  }
  const auto drive = parse_integer(text.substr(0, colon));
  const auto idn = parse_idn(text.substr(colon + 1, equals - colon - 1));
  if (!drive || *drive < 0 || *drive > 7 || !idn) {
    return bad_value(because("\"{text}\" is no IDN of a drive 0..7", text.substr(0, equals)));
  }
  auto data = parse_hex_data(text.substr(equals + 1));
  if (!data) return tl::unexpected(data.error());
  command.drive = static_cast<std::uint8_t>(*drive);
  command.idn = *idn;
  command.data = std::move(*data);
  return {};
}

}  // namespace

std::optional<std::uint16_t> parse_idn(std::string_view text) {
  if (text.size() < 5 || (text[0] != 'S' && text[0] != 'P') || text[1] != '-' || text[3] != '-') {
    const auto number = parse_integer(text);
    return number && *number >= 0 && *number <= 0xFFFF ? std::optional(static_cast<std::uint16_t>(*number))
                                                       : std::nullopt;
  }
  const auto set = parse_integer(text.substr(2, 1)), block = parse_integer(text.substr(4));
  if (!set || *set < 0 || *set > 7 || !block || *block < 0 || *block > 0xFFF) return std::nullopt;
  return static_cast<std::uint16_t>((text[0] == 'P' ? 0x8000 : 0) | *set << 12 | *block);
}

std::string format_soe(const SoeCommand& command) {
  return fmt::format("{} {}:{}={:02x}{}{}", transitions_text(command.transitions), command.drive,
                     soe::idn_text(command.idn), fmt::join(command.data, ""), format_usual_options(command),
                     format_comment(command.comment));
}

Result<SoeCommand> parse_soe(std::string_view text) {
  return parse_command<SoeCommand>(text, parse_target, parse_usual_option<SoeCommand>);
}

}  // namespace syncline::settings
