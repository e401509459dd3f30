// SPDX-License-Identifier: Apache-2.0
#include "master/startup/startup_messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/mailbox_config.h"
#include "protocol/aoe.h"
#include "protocol/command.h"
#include "protocol/eoe.h"
#include "protocol/foe.h"
#include "protocol/soe.h"
#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

template <class Command>
bool wanted(const Command& command, Transition transition) {
  return command.enabled && std::ranges::find(command.transitions, transition) != command.transitions.end();
}

/// Some tools write the parameters of "set IP" without the four bytes of EoE in front.
void complete_eoe(std::vector<std::uint8_t>& data) {
  if (!eoe::is_ip_parameters(data)) return;
  eoe::Header header;
  header.kind = eoe::Kind::kSetIpRequest;
  header.last_fragment = true;
  const auto bytes = eoe::encode(header);
  data.insert(data.begin(), bytes.begin(), bytes.end());
}

std::string name_of(MailboxType type, std::size_t number, const std::string& comment) {
  return fmt::format("{} start-up message {}{}", mailbox_type_name(type), number,
                     comment.empty() ? std::string() : " (" + comment + ")");
}

StartupAnswer refused(Reason why) { return {true, std::move(why)}; }

StartupAnswer judge_eoe(std::span<const std::uint8_t> data) {
  const auto header = eoe::decode(data);
  if (!header) return refused(header.error().detail);
  if (!header->is_response()) return {};  // a frame that the slave passes on
  return header->result == eoe::kSuccess
             ? StartupAnswer{true, {}}
             : refused(because("EoE result 0x{code}", fmt::format("{:04X}", header->result)));
}

StartupAnswer judge_soe(std::span<const std::uint8_t> data) {
  const auto header = soe::decode(data);
  if (!header) return refused(header.error().detail);
  if (header->op_code != soe::OpCode::kWriteResponse && header->op_code != soe::OpCode::kReadResponse) return {};
  if (!header->error) return {true, {}};
  const auto code =
      data.size() >= soe::Header::kSize + 2 ? load_le<std::uint16_t>(data.subspan(soe::Header::kSize)) : 0;
  return refused(because("SoE error 0x{code}", fmt::format("{:04X}", code)));
}

StartupAnswer judge_aoe(std::span<const std::uint8_t> data) {
  const auto header = aoe::decode(data);
  if (!header) return refused(header.error().detail);
  if (!header->is_response()) return {};
  // The command's own result stands first in the data.
  const auto own = data.size() >= aoe::Header::kSize + 4 ? load_le<std::uint32_t>(data.subspan(aoe::Header::kSize)) : 0;
  const auto code = header->error_code != 0 ? header->error_code : own;
  return code == 0 ? StartupAnswer{true, {}} : refused(because("AoE error 0x{code}", fmt::format("{:X}", code)));
}

StartupAnswer judge_foe(std::span<const std::uint8_t> data) {
  const auto message = foe::decode(data);
  if (!message) return refused(message.error().detail);
  if (const auto* error = std::get_if<foe::FileError>(&*message))
    return refused(because("FoE error 0x{code}", fmt::format("{:X}", error->code)));
  return {true, {}};
}

}  // namespace

std::vector<StartupMessage> startup_messages(const MailboxConfig& mailbox, Transition transition) {
  std::vector<StartupMessage> messages;
  const auto add = [&](MailboxType type, const std::vector<MailboxInitCmd>& commands) {
    for (std::size_t i = 0; i < commands.size(); ++i) {
      if (!wanted(commands[i], transition)) continue;
      messages.push_back({type, commands[i].data, commands[i].timeout_ms, name_of(type, i + 1, commands[i].comment),
                          type != MailboxType::kVoe});
      if (type == MailboxType::kEoe) complete_eoe(messages.back().data);
    }
  };
  add(MailboxType::kAoe, mailbox.aoe_commands);
  if (!mailbox.eoe_disabled) add(MailboxType::kEoe, mailbox.eoe_commands);
  for (std::size_t i = 0; i < mailbox.soe_commands.size(); ++i) {
    const auto& command = mailbox.soe_commands[i];
    if (!wanted(command, transition)) continue;
    soe::Header header;
    header.op_code = static_cast<soe::OpCode>(command.op_code & 0x07);
    header.drive_no = command.drive_no & 0x07;
    header.elements = command.elements;
    header.idn = command.idn;
    auto data = soe::encode(header);
    data.insert(data.end(), command.data.begin(), command.data.end());
    messages.push_back({MailboxType::kSoe, std::move(data), command.timeout_ms,
                        name_of(MailboxType::kSoe, i + 1, command.comment), true});
  }
  add(MailboxType::kFoe, mailbox.foe_commands);
  add(MailboxType::kVoe, mailbox.voe_commands);
  return messages;
}

StartupAnswer judge_startup_answer(MailboxType type, std::span<const std::uint8_t> data) {
  switch (type) {
    case MailboxType::kEoe:
      return judge_eoe(data);
    case MailboxType::kSoe:
      return judge_soe(data);
    case MailboxType::kAoe:
      return judge_aoe(data);
    case MailboxType::kFoe:
      return judge_foe(data);
    default:
      return {true, {}};
  }
}

}  // namespace syncline
