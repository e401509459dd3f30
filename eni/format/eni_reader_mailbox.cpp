// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "config/mailbox_config.h"
#include "eni/format/eni_element.h"
#include "eni/format/eni_reader.h"

namespace syncline::eni {
namespace {

MailboxChannel read_channel(const EniElement& element) {
  return {element.number_of<std::uint16_t>("Start"), element.number_of<std::uint16_t>("Length"),
          element.boolean_of("ShortSend")};
}

/// What the start-up commands of all protocols have in common.
template <class Cmd>
void read_common(const EniElement& element, Cmd& cmd) {
  cmd.transitions = read_transitions(element);
  cmd.comment = element.text_of("Comment");
  cmd.timeout_ms = element.number_of<std::uint32_t>("Timeout");
  cmd.data = element.child("Data").bytes();
  cmd.enabled = !element.boolean_of("Disabled");
  cmd.fixed = element.boolean_attribute("Fixed");
}

CoeInitCmd read_coe_cmd(const EniElement& element) {
  CoeInitCmd cmd;
  read_common(element, cmd.command);
  cmd.ccs = element.number_of<std::uint8_t>("Ccs", 1);
  cmd.command.index = element.number_of<std::uint16_t>("Index");
  cmd.command.sub_index = element.number_of<std::uint8_t>("SubIndex");
  cmd.command.complete_access = element.boolean_attribute("CompleteAccess");
  return cmd;
}

SoeInitCmd read_soe_cmd(const EniElement& element) {
  SoeInitCmd cmd;
  read_common(element, cmd);
  cmd.op_code = element.number_of<std::uint8_t>("OpCode", cmd.op_code);
  cmd.drive_no = element.number_of<std::uint8_t>("DriveNo");
  cmd.idn = element.number_of<std::uint16_t>("IDN");
  cmd.elements = element.number_of<std::uint8_t>("Elements", cmd.elements);
  cmd.attribute = element.number_of<std::uint8_t>("Attribute");
  return cmd;
}

MailboxInitCmd read_message(const EniElement& element) {
  MailboxInitCmd cmd;
  read_common(element, cmd);
  return cmd;
}

template <class Cmd>
std::vector<Cmd> read_list(const EniElement& protocol, Cmd (*read)(const EniElement&)) {
  return read_each(protocol.child("InitCmds").children("InitCmd"), read);
}

void read_protocols(const EniElement& element, MailboxConfig& mailbox) {
  const std::pair<std::string_view, bool*> protocols[] = {{"AoE", &mailbox.aoe}, {"EoE", &mailbox.eoe},
                                                          {"CoE", &mailbox.coe}, {"FoE", &mailbox.foe},
                                                          {"SoE", &mailbox.soe}, {"VoE", &mailbox.voe}};
  for (const EniElement& protocol : element.children("Protocol")) {
    const std::string name = protocol.text();
    const auto known = std::ranges::find(protocols, name, &std::pair<std::string_view, bool*>::first);
    if (known != std::end(protocols)) {
      *known->second = true;
    } else {
      protocol.report(ErrorCode::kXmlBadValue, name);
    }
  }
}

void read_commands(const EniElement& element, MailboxConfig& mailbox) {
  mailbox.coe_commands = read_list(element.child("CoE"), read_coe_cmd);
  mailbox.soe_commands = read_list(element.child("SoE"), read_soe_cmd);
  mailbox.aoe_commands = read_list(element.child("AoE"), read_message);
  mailbox.eoe_commands = read_list(element.child("EoE"), read_message);
  mailbox.foe_commands = read_list(element.child("FoE"), read_message);
  mailbox.voe_commands = read_list(element.child("VoE"), read_message);
  mailbox.aoe_net_id = element.child("AoE").text_of("NetId");
  mailbox.eoe_disabled = element.child("EoE").boolean_attribute("Disabled");
}

}  // namespace

std::optional<MailboxConfig> read_mailbox(const EniElement& element) {
  if (!element) {
    return std::nullopt;
  }
  MailboxConfig mailbox;
  mailbox.data_link_layer = element.boolean_attribute("DataLinkLayer");
  mailbox.send = read_channel(element.child("Send"));
  // "Receive" is what one hand-written file in the field says.
  const EniElement receive = element.child("Recv") ? element.child("Recv") : element.child("Receive");
  mailbox.receive = read_channel(receive);
  mailbox.poll_time_ms = receive.optional_number_of<std::uint32_t>("PollTime");
  mailbox.status_bit_address = receive.optional_number_of<std::uint32_t>("StatusBitAddr");
  if (const EniElement bootstrap = element.child("BootStrap")) {
    mailbox.bootstrap_send = read_channel(bootstrap.child("Send"));
    mailbox.bootstrap_receive = read_channel(bootstrap.child("Recv"));
  }
  read_protocols(element, mailbox);
  read_commands(element, mailbox);
  for (const EniElement& channel : element.child("CoE").child("Profile").children("ChannelInfo")) {
    mailbox.profiles.push_back(
        {channel.number_of<std::uint32_t>("ProfileNo"), channel.number_of<std::uint32_t>("AddInfo")});
  }
  return mailbox;
}

}  // namespace syncline::eni
