// SPDX-License-Identifier: Apache-2.0
#include <functional>

#include "config/mailbox_config.h"
#include "config/object_description.h"
#include "eni/format/eni_text.h"
#include "eni/format/eni_writer.h"

namespace syncline::eni {
namespace {

void write_channel(EniText& out, std::string_view element, const MailboxChannel& channel,
                   const std::function<void()>& further = {}) {
  out.open(element);
  out.number("Start", channel.start);
  out.number("Length", channel.length);
  if (channel.short_send) {
    out.boolean("ShortSend", true);
  }
  if (further) {
    further();
  }
  out.close();
}

/// What the start-up commands of all protocols begin with.
template <class Cmd>
void write_beginning(EniText& out, const Cmd& cmd) {
  for (const Transition transition : cmd.transitions) {
    out.text("Transition", transition_name(transition));
  }
  if (!cmd.comment.empty()) {
    out.text("Comment", cmd.comment);
  }
  out.number("Timeout", cmd.timeout_ms);
}

/// ... and end with.
template <class Cmd>
void write_end(EniText& out, const Cmd& cmd) {
  if (!cmd.data.empty()) {
    out.bytes("Data", cmd.data);
  }
  if (!cmd.enabled) {
    out.boolean("Disabled", true);
  }
  out.close();
}

void write_coe_cmd(EniText& out, const CoeInitCmd& cmd) {
  const StartupCommand& command = cmd.command;
  out.open("InitCmd", {{"Fixed", out.flag(command.fixed)}, {"CompleteAccess", out.flag(command.complete_access)}});
  write_beginning(out, command);
  out.number("Ccs", cmd.ccs);
  out.number("Index", command.index);
  out.number("SubIndex", command.sub_index);
  write_end(out, command);
}

void write_soe_cmd(EniText& out, const SoeInitCmd& cmd) {
  out.open("InitCmd", {{"Fixed", out.flag(cmd.fixed)}});
  write_beginning(out, cmd);
  out.number("OpCode", cmd.op_code);
  out.number("DriveNo", cmd.drive_no);
  out.number("IDN", cmd.idn);
  out.number("Elements", cmd.elements);
  out.number("Attribute", cmd.attribute);
  write_end(out, cmd);
}

void write_message(EniText& out, const MailboxInitCmd& cmd) {
  out.open("InitCmd", {{"Fixed", out.flag(cmd.fixed)}});
  write_beginning(out, cmd);
  // Demanded by the schema here, empty or not.
  if (cmd.data.empty()) {
    out.text("Data", "");
  }
  write_end(out, cmd);
}

template <class Cmd>
void write_list(EniText& out, const std::vector<Cmd>& cmds, void (*write)(EniText&, const Cmd&)) {
  if (cmds.empty()) {
    return;
  }
  out.open("InitCmds");
  for (const auto& cmd : cmds) {
    write(out, cmd);
  }
  out.close();
}

void write_profiles(EniText& out, const std::vector<ChannelProfile>& profiles) {
  if (profiles.empty()) {
    return;
  }
  out.open("Profile");
  for (const auto& profile : profiles) {
    out.open("ChannelInfo");
    out.number("ProfileNo", profile.profile_no);
    out.number("AddInfo", profile.add_info);
    out.close();
  }
  out.close();
}

void write_coe(EniText& out, const MailboxConfig& mailbox) {
  if (mailbox.coe_commands.empty() && mailbox.profiles.empty()) {
    return;
  }
  out.open("CoE");
  write_list(out, mailbox.coe_commands, write_coe_cmd);
  write_profiles(out, mailbox.profiles);
  out.close();
}

void write_soe(EniText& out, const MailboxConfig& mailbox) {
  if (!mailbox.soe_commands.empty()) {
    out.open("SoE");
    write_list(out, mailbox.soe_commands, write_soe_cmd);
    out.close();
  }
}

void write_aoe(EniText& out, const MailboxConfig& mailbox) {
  if (mailbox.aoe_commands.empty() && mailbox.aoe_net_id.empty()) {
    return;
  }
  out.open("AoE");
  write_list(out, mailbox.aoe_commands, write_message);
  if (!mailbox.aoe_net_id.empty()) {
    out.text("NetId", mailbox.aoe_net_id);
  }
  out.close();
}

void write_messages(EniText& out, std::string_view protocol, const std::vector<MailboxInitCmd>& cmds,
                    bool disabled = false) {
  if (!cmds.empty() || disabled) {
    out.open(protocol, {{"Disabled", out.flag(disabled)}});
    write_list(out, cmds, write_message);
    out.close();
  }
}

void write_protocols(EniText& out, const MailboxConfig& mailbox) {
  const std::pair<bool, std::string_view> protocols[] = {{mailbox.aoe, "AoE"}, {mailbox.eoe, "EoE"},
                                                         {mailbox.coe, "CoE"}, {mailbox.soe, "SoE"},
                                                         {mailbox.foe, "FoE"}, {mailbox.voe, "VoE"}};
  for (const auto& [supported, name] : protocols) {
    if (supported) {
      out.text("Protocol", name);
    }
  }
}

}  // namespace

void write_mailbox(EniText& out, const MailboxConfig& mailbox) {
  out.open("Mailbox", {{"DataLinkLayer", out.flag(mailbox.data_link_layer)}});
  write_channel(out, "Send", mailbox.send);
  write_channel(out, "Recv", mailbox.receive, [&] {
    if (mailbox.poll_time_ms) {
      out.number("PollTime", *mailbox.poll_time_ms);
    }
    if (mailbox.status_bit_address) {
      out.number("StatusBitAddr", *mailbox.status_bit_address);
    }
  });
  if (mailbox.bootstrap_send && mailbox.bootstrap_receive) {
    out.open("BootStrap");
    write_channel(out, "Send", *mailbox.bootstrap_send);
    write_channel(out, "Recv", *mailbox.bootstrap_receive);
    out.close();
  }
  write_protocols(out, mailbox);
  write_coe(out, mailbox);
  write_soe(out, mailbox);
  write_aoe(out, mailbox);
  write_messages(out, "EoE", mailbox.eoe_commands, mailbox.eoe_disabled);
  write_messages(out, "FoE", mailbox.foe_commands);
  write_messages(out, "VoE", mailbox.voe_commands);
  out.close();
}

}  // namespace syncline::eni
