// SPDX-License-Identifier: Apache-2.0
#include "eni/esi_device.h"
#include "eni/xml_text.h"

namespace syncline::eni {

StartupCommand read_init_cmd(const Node& node) {
  StartupCommand command;
  command.transitions.clear();
  for (const Node& transition : node.children("Transition")) {
    if (const auto known = transition_from_name(transition.trimmed())) {
      command.transitions.push_back(*known);
    } else {
      transition.fail(ErrorCode::kXmlBadValue, "\"" + transition.trimmed() + "\" is no state transition");
    }
  }
  if (command.transitions.empty()) (void)node.required("Transition");
  command.index = node.required("Index").number<std::uint16_t>();
  command.sub_index = node.child_number<std::uint8_t>("SubIndex").value_or(0);
  command.data = node.required("Data").bytes();
  command.comment = node.localized("Comment").trimmed();
  command.complete_access = node.boolean("CompleteAccess").value_or(false);
  command.fixed = node.boolean("Fixed").value_or(false);
  return command;
}

namespace {

CoeDescription read_coe(const Node& node) {
  CoeDescription coe;
  coe.sdo_info = node.boolean("SdoInfo").value_or(false);
  coe.pdo_assign = node.boolean("PdoAssign").value_or(false);
  coe.pdo_config = node.boolean("PdoConfig").value_or(false);
  coe.pdo_upload = node.boolean("PdoUpload").value_or(false);
  coe.complete_access = node.boolean("CompleteAccess").value_or(false);
  coe.segmented_sdo = node.boolean("SegmentedSdo").value_or(false);
  for (const Node& command : node.children("InitCmd")) coe.init_commands.push_back(read_init_cmd(command));
  return coe;
}

}  // namespace

MailboxDescription read_mailbox(const Node& device, const Node& node) {
  MailboxDescription mailbox;
  mailbox.data_link_layer = node.boolean("DataLinkLayer").value_or(false);
  mailbox.aoe = static_cast<bool>(node.child("AoE"));
  mailbox.eoe = static_cast<bool>(node.child("EoE"));
  mailbox.foe = static_cast<bool>(node.child("FoE"));
  mailbox.soe = static_cast<bool>(node.child("SoE"));
  mailbox.voe = static_cast<bool>(node.child("VoE"));
  if (const Node coe = node.child("CoE")) mailbox.coe = read_coe(coe);
  const Node timeout = device.child("Info").child("Mailbox").child("Timeout");
  if (const auto ms = timeout.child_number<std::uint32_t>("RequestTimeout")) mailbox.request_timeout_ms = *ms;
  if (const auto ms = timeout.child_number<std::uint32_t>("ResponseTimeout")) mailbox.response_timeout_ms = *ms;
  return mailbox;
}

}  // namespace syncline::eni
