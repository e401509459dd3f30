// SPDX-License-Identifier: Apache-2.0
#include "config/mailbox_description.h"
#include "eni/esi/esi_attributes.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

void write_transitions(XmlWriter& xml, const std::vector<Transition>& transitions) {
  for (const auto transition : transitions) xml.element("Transition", transition_name(transition));
}

void write_mailbox_commands(XmlWriter& xml, const std::vector<MailboxCommand>& commands, bool with_type) {
  for (const MailboxCommand& command : commands) {
    xml.open("InitCmd");
    write_transitions(xml, command.transitions);
    if (with_type) xml.element("Type", decimal(command.type));
    xml.element("Data", hex_bytes(command.data));
    text_element(xml, "Comment", command.comment);
    xml.close();
  }
}

void write_aoe(XmlWriter& xml, const AoeDescription& aoe) {
  xml.open("AoE");
  flag(xml, "AdsRouter", aoe.ads_router);
  flag(xml, "GenerateOwnNetId", aoe.generate_own_net_id);
  flag(xml, "InitializeOwnNetId", aoe.initialize_own_net_id);
  write_mailbox_commands(xml, aoe.init_commands, false);
  xml.close();
}

void write_eoe(XmlWriter& xml, const EoeDescription& eoe) {
  xml.open("EoE");
  flag(xml, "IP", eoe.ip);
  flag(xml, "MAC", eoe.mac);
  flag(xml, "TimeStamp", eoe.time_stamp);
  write_mailbox_commands(xml, eoe.init_commands, true);
  xml.close();
}

void write_soe(XmlWriter& xml, const SoeDescription& soe) {
  xml.open("SoE");
  optional_attribute(xml, "ChannelCount", soe.channel_count);
  flag(xml, "DriveFollowsBit3Support", soe.drive_follows_bit3);
  for (const SoeCommand& command : soe.init_commands) {
    xml.open("InitCmd");
    if (command.drive != 0) xml.attribute("Chn", decimal(command.drive));
    flag(xml, "Fixed", command.fixed);
    write_transitions(xml, command.transitions);
    xml.element("IDN", decimal(command.idn)).element("Data", hex_bytes(command.data));
    text_element(xml, "Comment", command.comment);
    xml.close();
  }
  xml.close();
}

}  // namespace

void write_init_cmd_content(XmlWriter& xml, const StartupCommand& command) {
  write_transitions(xml, command.transitions);
  index_element(xml, "Index", command.index, command.depend_on_slot, command.depend_on_slot_group);
  xml.element("SubIndex", decimal(command.sub_index));
  xml.open("Data");
  flag(xml, "AdaptAutomatically", command.adapt_automatically);
  xml.text(hex_bytes(command.data)).close();
  text_element(xml, "Comment", command.comment);
}

void write_coe(XmlWriter& xml, const CoeDescription& coe) {
  xml.open("CoE");
  flag(xml, "SdoInfo", coe.sdo_info);
  flag(xml, "PdoAssign", coe.pdo_assign);
  flag(xml, "PdoConfig", coe.pdo_config);
  flag(xml, "PdoUpload", coe.pdo_upload);
  flag(xml, "CompleteAccess", coe.complete_access);
  text_attribute(xml, "EdsFile", coe.eds_file);
  optional_attribute(xml, "DS402Channels", coe.ds402_channels);
  flag(xml, "SegmentedSdo", coe.segmented_sdo);
  flag(xml, "DiagHistory", coe.diag_history);
  flag(xml, "ModuleOD", coe.module_od);
  for (const StartupCommand& command : coe.init_commands) {
    xml.open("InitCmd");
    flag(xml, "Fixed", command.fixed);
    flag(xml, "CompleteAccess", command.complete_access);
    flag(xml, "OverwrittenByModule", command.overwritten_by_module);
    write_init_cmd_content(xml, command);
    xml.close();
  }
  xml.close();
}

void write_mailbox(XmlWriter& xml, const MailboxDescription& mailbox) {
  xml.open("Mailbox");
  flag(xml, "DataLinkLayer", mailbox.data_link_layer);
  flag(xml, "RealTimeMode", mailbox.real_time_mode);
  if (mailbox.aoe) write_aoe(xml, mailbox.aoe_options);
  if (mailbox.eoe) write_eoe(xml, mailbox.eoe_options);
  if (mailbox.coe) write_coe(xml, *mailbox.coe);
  if (mailbox.foe) xml.element("FoE", "");
  if (mailbox.soe) write_soe(xml, mailbox.soe_options);
  if (mailbox.voe) xml.element("VoE", "");
  xml.close();
}

}  // namespace syncline::eni
