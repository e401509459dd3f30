// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "eni/eni_reader.h"
#include "support/types.h"

namespace syncline::eni {
namespace {

constexpr std::uint16_t kFirstStationAddress = 1001;
constexpr std::uint16_t kAliasRegister = 0x0012;
constexpr int kMaxSyncManagers = 16;

void read_info(const EniElement& info, SlaveConfig& slave, std::uint16_t position) {
  slave.name = info.text_of("Name");
  slave.station_address =
      info.number_of<std::uint16_t>("PhysAddr", static_cast<std::uint16_t>(kFirstStationAddress + position));
  slave.auto_increment_address =
      info.number_of<std::uint16_t>("AutoIncAddr", Position{position}.auto_increment_address());
  if (const EniElement identification = info.child("Identification");
      identification && identification.number_of<std::uint16_t>("Ado") == kAliasRegister) {
    slave.alias = identification.number_attribute<std::uint16_t>("Value").value_or(0);
  }
  slave.physics = info.text_of("Physics");
  slave.identity = {info.number_of<std::uint32_t>("VendorId"), info.number_of<std::uint32_t>("ProductCode"),
                    info.number_of<std::uint32_t>("RevisionNo"), info.number_of<std::uint32_t>("SerialNo")};
}

std::optional<ImageRange> read_range(const EniElement& process_data, const char* name) {
  const auto parts = process_data.children(name);
  if (parts.empty()) {
    return std::nullopt;
  }
  // One element a SyncManager is allowed; the slave's part of the image spans them.
  std::uint32_t first = UINT32_MAX;
  std::uint32_t end = 0;
  for (const EniElement& part : parts) {
    const auto start = part.number_of<std::uint32_t>("BitStart");
    first = std::min(first, start);
    end = std::max(end, start + part.number_of<std::uint32_t>("BitLength"));
  }
  return ImageRange{first, end - first};
}

SyncManagerType read_type(const EniElement& element) {
  const std::string type = element.text();
  if (type == "MBoxOut") return SyncManagerType::kMailboxOut;
  if (type == "MBoxIn") return SyncManagerType::kMailboxIn;
  if (type == "Outputs") return SyncManagerType::kOutputs;
  if (type == "Inputs") return SyncManagerType::kInputs;
  if (element) {
    element.report(ErrorCode::kXmlBadValue, type);
  }
  return SyncManagerType::kUnused;
}

ConfiguredSyncManager read_sync_manager(const EniElement& element, int number) {
  ConfiguredSyncManager manager;
  manager.number = static_cast<std::uint8_t>(number);
  SyncManagerDescription& description = manager.description;
  description.type = read_type(element.child("Type"));
  description.start_address = element.number_of<std::uint16_t>("StartAddress");
  description.min_size = element.optional_number_of<std::uint16_t>("MinSize");
  description.max_size = element.optional_number_of<std::uint16_t>("MaxSize");
  description.default_size = element.optional_number_of<std::uint16_t>("DefaultSize");
  description.control_byte = element.number_of<std::uint8_t>("ControlByte");
  description.enable = element.boolean_of("Enable");
  description.is_virtual = element.boolean_of("Virtual");
  for (const EniElement& pdo : element.children("Pdo")) {
    manager.pdos.push_back(pdo.number<std::uint16_t>());
  }
  return manager;
}

ConfiguredPdo read_pdo(const EniElement& element) {
  ConfiguredPdo out;
  out.direction = element.name() == "TxPdo" ? PdoDirection::kTx : PdoDirection::kRx;
  Pdo& pdo = out.pdo;
  pdo.index = element.number_of<std::uint16_t>("Index");
  pdo.name = element.text_of("Name");
  pdo.sync_manager = element.number_attribute<std::uint8_t>("Sm");
  pdo.fixed = element.boolean_attribute("Fixed");
  pdo.mandatory = element.boolean_attribute("Mandatory");
  for (const EniElement& excluded : element.children("Exclude")) {
    pdo.exclude.push_back(excluded.number<std::uint16_t>());
  }
  for (const EniElement& entry : element.children("Entry")) {
    pdo.entries.push_back({entry.number_of<std::uint16_t>("Index"), entry.number_of<std::uint8_t>("SubIndex"),
                           entry.number_of<std::uint16_t>("BitLen"), entry.text_of("Name"), entry.text_of("DataType")});
  }
  return out;
}

void read_process_data(const EniElement& process_data, SlaveConfig& slave) {
  slave.send = read_range(process_data, "Send");
  slave.receive = read_range(process_data, "Recv");
  for (int number = 0; number < kMaxSyncManagers; ++number) {
    const std::string name = "Sm" + std::to_string(number);
    if (const EniElement element = process_data.child(name.c_str())) {
      slave.sync_managers.push_back(read_sync_manager(element, number));
    }
  }
  for (const char* name : {"TxPdo", "RxPdo"}) {
    for (const EniElement& pdo : process_data.children(name)) {
      slave.pdos.push_back(read_pdo(pdo));
    }
  }
}

MailboxChannel read_channel(const EniElement& element) {
  return {element.number_of<std::uint16_t>("Start"), element.number_of<std::uint16_t>("Length")};
}

CoeInitCmd read_coe_cmd(const EniElement& element) {
  CoeInitCmd cmd;
  StartupCommand& command = cmd.command;
  command.transitions = read_transitions(element);
  command.comment = element.text_of("Comment");
  command.timeout_ms = element.number_of<std::uint32_t>("Timeout");
  cmd.ccs = element.number_of<std::uint8_t>("Ccs", 1);
  command.index = element.number_of<std::uint16_t>("Index");
  command.sub_index = element.number_of<std::uint8_t>("SubIndex");
  command.data = element.child("Data").bytes();
  command.enabled = !element.boolean_of("Disabled");
  command.fixed = element.boolean_attribute("Fixed");
  command.complete_access = element.boolean_attribute("CompleteAccess");
  return cmd;
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
  const EniElement coe = element.child("CoE");
  for (const EniElement& cmd : coe.child("InitCmds").children("InitCmd")) {
    mailbox.coe_commands.push_back(read_coe_cmd(cmd));
  }
  for (const EniElement& channel : coe.child("Profile").children("ChannelInfo")) {
    mailbox.profiles.push_back(
        {channel.number_of<std::uint32_t>("ProfileNo"), channel.number_of<std::uint32_t>("AddInfo")});
  }
  return mailbox;
}

std::optional<HotConnectConfig> read_hot_connect(const EniElement& element) {
  if (!element) {
    return std::nullopt;
  }
  HotConnectConfig group;
  group.group = element.text_of("GroupName");
  group.member_count = std::max<std::uint16_t>(1, element.number_of<std::uint16_t>("GroupMemberCnt", 1));
  for (const EniElement& command : element.children("IdentifyCmd")) {
    group.identify_cmds.push_back(read_init_cmd(command));
  }
  return group;
}

std::optional<SlaveDcConfig> read_dc(const EniElement& element) {
  SlaveDcConfig dc;
  dc.potential_reference_clock = element.boolean_of("PotentialReferenceClock");
  // A DC element that says only "no potential reference clock" is how tools mark a slave without DC.
  if (!element.child("ReferenceClock") && !element.child("CycleTime0") && !dc.potential_reference_clock) {
    return std::nullopt;
  }
  dc.reference_clock = element.boolean_of("ReferenceClock");
  dc.cycle_time0 = element.number_of<std::int64_t>("CycleTime0");
  dc.cycle_time1 = element.number_of<std::int64_t>("CycleTime1");
  dc.shift_time = element.number_of<std::int64_t>("ShiftTime");
  return dc;
}

}  // namespace

SlaveConfig read_slave(const EniElement& element, std::uint16_t position) {
  SlaveConfig slave;
  read_info(element.required("Info"), slave, position);
  read_process_data(element.child("ProcessData"), slave);
  slave.mailbox = read_mailbox(element.child("Mailbox"));
  slave.init_cmds = read_init_cmds(element.child("InitCmds"));
  slave.hot_connect = read_hot_connect(element.child("HotConnect"));
  slave.dc = read_dc(element.child("DC"));
  derive_slave(slave);
  return slave;
}

}  // namespace syncline::eni
