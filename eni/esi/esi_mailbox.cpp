// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_device.h"
#include "eni/xml/xml_text.h"

namespace syncline::eni {
namespace {

MailboxCommand read_mailbox_command(const Node& node) {
  MailboxCommand command;
  command.transitions = read_transitions(node);
  command.type = node.child_number<int>("Type").value_or(0);
  command.data = node.required("Data").bytes();
  command.comment = node.localized("Comment").trimmed();
  return command;
}

AoeDescription read_aoe(const Node& node) {
  AoeDescription aoe;
  aoe.ads_router = node.boolean("AdsRouter").value_or(false);
  aoe.generate_own_net_id = node.boolean("GenerateOwnNetId").value_or(false);
  aoe.initialize_own_net_id = node.boolean("InitializeOwnNetId").value_or(false);
  for (const Node& command : node.children("InitCmd")) aoe.init_commands.push_back(read_mailbox_command(command));
  return aoe;
}

EoeDescription read_eoe(const Node& node) {
  EoeDescription eoe;
  eoe.ip = node.boolean("IP").value_or(false);
  eoe.mac = node.boolean("MAC").value_or(false);
  eoe.time_stamp = node.boolean("TimeStamp").value_or(false);
  for (const Node& command : node.children("InitCmd")) eoe.init_commands.push_back(read_mailbox_command(command));
  return eoe;
}

SoeCommand read_soe_command(const Node& node) {
  SoeCommand command;
  command.transitions = read_transitions(node);
  command.drive = node.number<std::uint8_t>("Chn").value_or(0);
  command.idn = node.required("IDN").number<std::uint16_t>();
  command.data = node.required("Data").bytes();
  command.comment = node.localized("Comment").trimmed();
  command.fixed = node.boolean("Fixed").value_or(false);
  return command;
}

SoeDescription read_soe(const Node& node) {
  SoeDescription soe;
  soe.channel_count = node.number<std::uint8_t>("ChannelCount");
  soe.drive_follows_bit3 = node.boolean("DriveFollowsBit3Support").value_or(false);
  for (const Node& command : node.children("InitCmd")) soe.init_commands.push_back(read_soe_command(command));
  return soe;
}

}  // namespace

CoeDescription read_coe(const Node& node) {
  CoeDescription coe;
  coe.sdo_info = node.boolean("SdoInfo").value_or(false);
  coe.pdo_assign = node.boolean("PdoAssign").value_or(false);
  coe.pdo_config = node.boolean("PdoConfig").value_or(false);
  coe.pdo_upload = node.boolean("PdoUpload").value_or(false);
  coe.complete_access = node.boolean("CompleteAccess").value_or(false);
  coe.segmented_sdo = node.boolean("SegmentedSdo").value_or(false);
  coe.diag_history = node.boolean("DiagHistory").value_or(false);
  coe.module_od = node.boolean("ModuleOD").value_or(false);
  coe.ds402_channels = node.number<std::uint16_t>("DS402Channels");
  coe.eds_file = node.attribute("EdsFile");
  for (const Node& command : node.children("InitCmd")) coe.init_commands.push_back(read_init_cmd(command));
  return coe;
}

MailboxDescription read_mailbox(const Node& device, const Node& node) {
  MailboxDescription mailbox;
  mailbox.data_link_layer = node.boolean("DataLinkLayer").value_or(false);
  mailbox.real_time_mode = node.boolean("RealTimeMode").value_or(false);
  mailbox.aoe = static_cast<bool>(node.child("AoE"));
  mailbox.eoe = static_cast<bool>(node.child("EoE"));
  mailbox.foe = static_cast<bool>(node.child("FoE"));
  mailbox.soe = static_cast<bool>(node.child("SoE"));
  mailbox.voe = static_cast<bool>(node.child("VoE"));
  mailbox.aoe_options = read_aoe(node.child("AoE"));
  mailbox.eoe_options = read_eoe(node.child("EoE"));
  mailbox.soe_options = read_soe(node.child("SoE"));
  if (const Node coe = node.child("CoE")) mailbox.coe = read_coe(coe);
  const Node timeout = device.child("Info").child("Mailbox").child("Timeout");
  if (const auto ms = timeout.child_number<std::uint32_t>("RequestTimeout")) mailbox.request_timeout_ms = *ms;
  if (const auto ms = timeout.child_number<std::uint32_t>("ResponseTimeout")) mailbox.response_timeout_ms = *ms;
  return mailbox;
}

}  // namespace syncline::eni
