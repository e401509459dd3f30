// SPDX-License-Identifier: Apache-2.0
#include "eni/eni_writer.h"

namespace syncline::eni {
namespace {

std::string_view type_name(SyncManagerType type) {
  switch (type) {
    case SyncManagerType::kMailboxOut: return "MBoxOut";
    case SyncManagerType::kMailboxIn: return "MBoxIn";
    case SyncManagerType::kInputs: return "Inputs";
    case SyncManagerType::kOutputs:
    case SyncManagerType::kUnused: break;
  }
  return "Outputs";
}

void write_range(EniText& out, std::string_view element, const std::optional<ImageRange>& range) {
  if (range) {
    out.open(element);
    out.number("BitStart", range->bit_start);
    out.number("BitLength", range->bit_length);
    out.close();
  }
}

void write_optional(EniText& out, std::string_view element, const std::optional<std::uint16_t>& value) {
  if (value) {
    out.number(element, *value);
  }
}

void write_sync_manager(EniText& out, const ConfiguredSyncManager& manager) {
  const SyncManagerDescription& description = manager.description;
  out.open("Sm" + EniText::decimal(manager.number));
  out.text("Type", type_name(description.type));
  write_optional(out, "MinSize", description.min_size);
  write_optional(out, "MaxSize", description.max_size);
  write_optional(out, "DefaultSize", description.default_size);
  out.number("StartAddress", description.start_address);
  out.number("ControlByte", description.control_byte);
  out.boolean("Enable", description.enable);
  if (description.is_virtual) {
    out.boolean("Virtual", true);
  }
  for (const std::uint16_t pdo : manager.pdos) {
    out.number("Pdo", pdo);
  }
  out.close();
}

void write_entry(EniText& out, const PdoEntry& entry) {
  out.open("Entry");
  out.hex_number("Index", entry.index);
  if (entry.index != 0) {
    out.number("SubIndex", entry.sub_index);
  }
  out.number("BitLen", entry.bit_length);
  if (entry.index != 0 || !entry.name.empty()) {
    out.text("Name", entry.name);
  }
  if (!entry.data_type.empty()) {
    out.text("DataType", entry.data_type);
  }
  out.close();
}

void write_pdo(EniText& out, const ConfiguredPdo& configured) {
  const Pdo& pdo = configured.pdo;
  out.open(configured.direction == PdoDirection::kTx ? "TxPdo" : "RxPdo",
           {{"Fixed", pdo.fixed ? "1" : ""},
            {"Mandatory", pdo.mandatory ? "1" : ""},
            {"Sm", pdo.sync_manager ? EniText::decimal(*pdo.sync_manager) : ""}});
  out.hex_number("Index", pdo.index);
  out.text("Name", pdo.name);
  for (const std::uint16_t excluded : pdo.exclude) {
    out.hex_number("Exclude", excluded);
  }
  for (const PdoEntry& entry : pdo.entries) {
    write_entry(out, entry);
  }
  out.close();
}

void write_channel(EniText& out, std::string_view element, const MailboxChannel& channel) {
  out.open(element);
  out.number("Start", channel.start);
  out.number("Length", channel.length);
  out.close();
}

void write_receive(EniText& out, const MailboxConfig& mailbox) {
  out.open("Recv");
  out.number("Start", mailbox.receive.start);
  out.number("Length", mailbox.receive.length);
  if (mailbox.poll_time_ms) {
    out.number("PollTime", *mailbox.poll_time_ms);
  }
  if (mailbox.status_bit_address) {
    out.number("StatusBitAddr", *mailbox.status_bit_address);
  }
  out.close();
}

void write_coe_cmd(EniText& out, const CoeInitCmd& cmd) {
  const StartupCommand& command = cmd.command;
  out.open("InitCmd", {{"Fixed", command.fixed ? "1" : ""}, {"CompleteAccess", command.complete_access ? "1" : ""}});
  for (const Transition transition : command.transitions) {
    out.text("Transition", transition_name(transition));
  }
  if (!command.comment.empty()) {
    out.text("Comment", command.comment);
  }
  out.number("Timeout", command.timeout_ms);
  out.number("Ccs", cmd.ccs);
  out.number("Index", command.index);
  out.number("SubIndex", command.sub_index);
  if (!command.data.empty()) {
    out.bytes("Data", command.data);
  }
  if (!command.enabled) {
    out.boolean("Disabled", true);
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
  if (!mailbox.coe_commands.empty()) {
    out.open("InitCmds");
    for (const auto& cmd : mailbox.coe_commands) {
      write_coe_cmd(out, cmd);
    }
    out.close();
  }
  write_profiles(out, mailbox.profiles);
  out.close();
}

}  // namespace

void write_process_data(EniText& out, const SlaveConfig& slave) {
  if (!slave.send && !slave.receive && slave.sync_managers.empty() && slave.pdos.empty()) {
    return;
  }
  out.open("ProcessData");
  write_range(out, "Send", slave.send);
  write_range(out, "Recv", slave.receive);
  for (const auto& manager : slave.sync_managers) {
    write_sync_manager(out, manager);
  }
  for (const auto& pdo : slave.pdos) {
    write_pdo(out, pdo);
  }
  out.close();
}

void write_mailbox(EniText& out, const MailboxConfig& mailbox) {
  out.open("Mailbox", {{"DataLinkLayer", mailbox.data_link_layer ? "1" : ""}});
  write_channel(out, "Send", mailbox.send);
  write_receive(out, mailbox);
  if (mailbox.bootstrap_send && mailbox.bootstrap_receive) {
    out.open("BootStrap");
    write_channel(out, "Send", *mailbox.bootstrap_send);
    write_channel(out, "Recv", *mailbox.bootstrap_receive);
    out.close();
  }
  const std::pair<bool, std::string_view> protocols[] = {{mailbox.aoe, "AoE"}, {mailbox.eoe, "EoE"},
                                                         {mailbox.coe, "CoE"}, {mailbox.soe, "SoE"},
                                                         {mailbox.foe, "FoE"}, {mailbox.voe, "VoE"}};
  for (const auto& [supported, name] : protocols) {
    if (supported) {
      out.text("Protocol", name);
    }
  }
  write_coe(out, mailbox);
  out.close();
}

}  // namespace syncline::eni
