// SPDX-License-Identifier: Apache-2.0
#include "config/startup_messages.h"

#include "protocol/eoe.h"

namespace syncline {
namespace {

/// The header as tools write it: no fragment, no time stamp.
std::vector<std::uint8_t> with_eoe_header(int service, const std::vector<std::uint8_t>& data) {
  constexpr int kServices = 0x0F;
  eoe::Header header;
  header.kind = static_cast<eoe::Kind>(service & kServices);
  header.last_fragment = header.kind == eoe::Kind::kFragment;
  auto bytes = eoe::encode(header);
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

}  // namespace

std::vector<MailboxInitCmd> esi_messages(const DeviceDescription& device, MailboxType type) {
  std::vector<MailboxInitCmd> messages;
  if (!device.mailbox) return messages;
  const bool eoe = type == MailboxType::kEoe;
  if (eoe ? !device.mailbox->eoe : type != MailboxType::kAoe || !device.mailbox->aoe) return messages;
  const auto& commands = eoe ? device.mailbox->eoe_options.init_commands : device.mailbox->aoe_options.init_commands;
  for (const MailboxCommand& command : commands) {
    auto& message = messages.emplace_back();
    message.transitions = command.transitions;
    message.data = eoe ? with_eoe_header(command.type, command.data) : command.data;
    message.comment = command.comment;
  }
  return messages;
}

bool speaks(const DeviceDescription& device, const MessageProtocol& protocol) {
  return device.mailbox && (*device.mailbox).*protocol.known;
}

}  // namespace syncline
