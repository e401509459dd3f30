// SPDX-License-Identifier: Apache-2.0
#include "settings/message_text.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "config/command_text.h"
#include "config/mailbox_config.h"
#include "config/register_command.h"
#include "protocol/frame.h"
#include "reasons/because.h"
#include "settings/command_words.h"
#include "settings/number_text.h"
#include "settings/setting_type.h"

namespace syncline::settings {
namespace {

constexpr std::string_view kData = "data=", kExpect = "expect=", kMask = "mask=", kWithin = "within=";
constexpr std::int64_t kRegisters = 0x10000;

Status parse_bytes(std::string_view text, std::vector<std::uint8_t>& bytes) {
  auto data = parse_hex_data(text);
  if (!data) return tl::unexpected(data.error());
  bytes = std::move(*data);
  return {};
}

Status parse_data(std::string_view& rest, MailboxInitCmd& message) {
  const auto word = next_word(rest);
  const auto digits = value_of(word, kData);
  if (!digits) return bad_value(because("\"{text}\" is no data=HEX like data=0200", word));
  return parse_bytes(*digits, message.data);
}

/// "0x09a8=0100" of a write, "0x0130*2" of a read.
Status parse_register_place(std::string_view text, RegisterCommand& command) {
  const auto mark = text.find(command.read ? '*' : '=');
  const auto wrong = [&] {
    return bad_value(because("\"{text}\" is no REGISTER=DATA like 0x09A8=0100, nor, for a read, REGISTER*BYTES", text));
  };
  if (mark == std::string_view::npos) return wrong();
  const auto address = parse_integer(text.substr(0, mark));
  if (!address || *address < 0) return wrong();
  if (command.read) {
    const auto length = parse_integer(text.substr(mark + 1));
    if (!length || *length < 1 || std::cmp_greater(*length, kMaxDatagramData)) return wrong();
    command.data.assign(static_cast<std::size_t>(*length), 0);
  } else {
    auto data = parse_hex_data(text.substr(mark + 1));
    if (!data) return tl::unexpected(data.error());
    if (data->empty() || std::cmp_greater(data->size(), kMaxDatagramData)) return wrong();
    command.data = std::move(*data);
  }
  if (*address + static_cast<std::int64_t>(command.data.size()) > kRegisters) return wrong();
  command.address = static_cast<std::uint16_t>(*address);
  return {};
}

/// "write" or "read", and where.
Status parse_access(std::string_view& rest, RegisterCommand& command) {
  const auto direction = next_word(rest);
  command.read = direction == "read";
  if (!command.read && direction != "write")
    return bad_value(because("\"{text}\" is neither write nor read", direction));
  return parse_register_place(next_word(rest), command);
}

Status parse_register_option(std::string_view word, RegisterCommand& command) {
  if (const auto expected = value_of(word, kExpect)) return parse_bytes(*expected, command.expected);
  if (const auto mask = value_of(word, kMask)) return parse_bytes(*mask, command.mask);
  const auto within = value_of(word, kWithin);
  const auto ms = within ? parse_milliseconds(*within) : std::nullopt;
  if (ms) {
    command.timeout_ms = *ms;
  } else if (word == "off") {
    command.enabled = false;
  } else if (word == "after") {
    command.after_slaves = true;
  } else {
    return bad_value(because("\"{text}\" is none of expect=HEX, mask=HEX, within=MS, off, after", word));
  }
  return {};
}

/// What is compared is as long as what is read.
Status check_expected(const RegisterCommand& command) {
  const auto fits = [&](const std::vector<std::uint8_t>& bytes) {
    return bytes.empty() || (command.read && bytes.size() == command.data.size());
  };
  if (fits(command.expected) && fits(command.mask) && (command.mask.empty() || !command.expected.empty())) return {};
  return bad_value(because("only a read expects a value, of as many bytes as it reads; a mask is as long"));
}

}  // namespace

std::string format_message(const MailboxInitCmd& message) {
  return fmt::format("{} {}{:02x}{}{}", transitions_text(message.transitions), kData, fmt::join(message.data, ""),
                     format_usual_options(message), format_comment(message.comment));
}

Result<MailboxInitCmd> parse_message(std::string_view text) {
  return parse_command<MailboxInitCmd>(text, parse_data, parse_usual_option<MailboxInitCmd>);
}

std::string format_register(const RegisterCommand& command) {
  std::string text = fmt::format("{} {} 0x{:04x}", transitions_text(command.transitions),
                                 command.read ? "read" : "write", command.address);
  if (command.read) {
    text += fmt::format("*{}", command.data.size());
  } else {
    text += fmt::format("={:02x}", fmt::join(command.data, ""));
  }
  if (!command.expected.empty()) text += fmt::format(" {}{:02x}", kExpect, fmt::join(command.expected, ""));
  if (!command.mask.empty()) text += fmt::format(" {}{:02x}", kMask, fmt::join(command.mask, ""));
  if (command.timeout_ms != RegisterCommand::kUsualTimeoutMs) text += fmt::format(" {}{}", kWithin, command.timeout_ms);
  if (!command.enabled) text += " off";
  if (command.after_slaves) text += " after";
  return text + format_comment(command.comment);
}

Result<RegisterCommand> parse_register(std::string_view text) {
  auto command = parse_command<RegisterCommand>(text, parse_access, parse_register_option);
  if (!command) return command;
  if (auto status = check_expected(*command); !status) return tl::unexpected(status.error());
  return command;
}

}  // namespace syncline::settings
