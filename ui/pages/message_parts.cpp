// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/message_parts.h"

#include <algorithm>

#include "config/device_description.h"
#include "config/mailbox_config.h"
#include "config/startup_origin.h"
#include "settings/message_text.h"

namespace syncline::ui {
namespace {

MailboxInitCmd startupMessageOf(const std::string& record) {
  return settings::parse_message(record).value_or(MailboxInitCmd{});
}
constexpr CommandCodec<MailboxInitCmd> kMessage{startupMessageOf, settings::format_message};

/// Object names of the parts of one protocol.
struct MessageNames {
  MailboxType protocol;
  const char *enabled, *transitions, *data, *origin, *comment, *timeout, *fixed;
};
constexpr MessageNames kMessageNames[] = {
    {MailboxType::kAoe, "aoeMessageEnabled", "aoeMessageTransitions", "aoeMessageData", "aoeMessageOrigin",
     "aoeMessageComment", "aoeMessageTimeout", "aoeMessageFixed"},
    {MailboxType::kEoe, "eoeMessageEnabled", "eoeMessageTransitions", "eoeMessageData", "eoeMessageOrigin",
     "eoeMessageComment", "eoeMessageTimeout", "eoeMessageFixed"},
    {MailboxType::kFoe, "foeMessageEnabled", "foeMessageTransitions", "foeMessageData", "foeMessageOrigin",
     "foeMessageComment", "foeMessageTimeout", "foeMessageFixed"},
    {MailboxType::kVoe, "voeMessageEnabled", "voeMessageTransitions", "voeMessageData", "voeMessageOrigin",
     "voeMessageComment", "voeMessageTimeout", "voeMessageFixed"}};

QString messageTip(MailboxType protocol) {
  switch (protocol) {
    case MailboxType::kAoe:
      return CommandWords::tr("AoE header and data, hexadecimal, in the order of the wire (ENI InitCmd/Data)");
    case MailboxType::kEoe:
      return CommandWords::tr("EoE header and data, hexadecimal, in the order of the wire (ENI InitCmd/Data)");
    case MailboxType::kFoe:
      return CommandWords::tr("FoE request, hexadecimal, in the order of the wire (ENI InitCmd/Data)");
    default:
      return CommandWords::tr(
          "What follows the mailbox header, hexadecimal, in the order of the wire (ENI InitCmd/Data)");
  }
}

}  // namespace

std::vector<RecordPart> messageParts(MailboxType protocol, const ShownDevice& device) {
  const auto& names = *std::ranges::find(kMessageNames, protocol, &MessageNames::protocol);
  const auto from_esi = [protocol](const MailboxInitCmd& message, const DeviceDescription& of) {
    return is_from_esi(message, of, protocol);
  };
  return {
      togglePart(kMessage, names.enabled, CommandWords::tr("Enabled"),
                 CommandWords::tr("Off: the command is kept, but not sent"), 58, &MailboxInitCmd::enabled),
      transitionPart(kMessage, names.transitions),
      bytesPart(kMessage, names.data, CommandWords::tr("Message"), messageTip(protocol), 170, &MailboxInitCmd::data),
      originPart(kMessage, names.origin, device, from_esi),
      commentPart(kMessage, names.comment),
      timeoutPart(kMessage, names.timeout),
      togglePart(kMessage, names.fixed, CommandWords::tr("Fixed"),
                 CommandWords::tr("The device needs the command as it is (ENI InitCmd@Fixed)"), -1,
                 &MailboxInitCmd::fixed)};
}

}  // namespace syncline::ui
