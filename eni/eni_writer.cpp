// SPDX-License-Identifier: Apache-2.0
#include "eni/eni_writer.h"

#include "eni/eni_file.h"
#include "eni/xml_text.h"

namespace syncline::eni {
namespace {

constexpr std::uint32_t kMailboxStateStart = 0x0900'0000;
constexpr std::uint32_t kEoePorts = 2, kEoeFrames = 120, kEoeMacs = 100;

void write_dc(EniText& out, const std::optional<SlaveDcConfig>& dc) {
  out.open("DC");
  out.boolean("PotentialReferenceClock", dc && dc->potential_reference_clock);
  if (dc && (dc->assign_activate != 0 || dc->reference_clock)) {
    out.boolean("ReferenceClock", dc->reference_clock);
    out.signed_number("CycleTime0", dc->cycle_time0);
    out.signed_number("CycleTime1", dc->cycle_time1);
    out.signed_number("ShiftTime", dc->shift_time);
  }
  out.close();
}

void write_previous(EniText& out, const PreviousPort& previous, const std::vector<SlaveConfig>& all) {
  // The schema knows ports B to D only.
  if (previous.port < 1 || previous.port > 3 || previous.position >= all.size()) {
    return;
  }
  out.open("PreviousPort", {{"Selected", "1"}});
  out.text("Port", std::string(1, static_cast<char>('A' + previous.port)));
  out.number("PhysAddr", all[previous.position].station_address);
  out.close();
}

void write_hot_connect(EniText& out, const HotConnectConfig& group) {
  out.open("HotConnect");
  out.text("GroupName", group.group);
  out.number("GroupMemberCnt", group.member_count);
  for (const auto& command : group.identify_cmds) {
    write_init_cmd(out, command, "IdentifyCmd");
  }
  out.close();
}

void write_info(EniText& out, const SlaveConfig& slave) {
  out.open("Info");
  out.text("Name", slave.name);
  out.number("PhysAddr", slave.station_address);
  out.number("AutoIncAddr", slave.auto_increment_address);
  if (slave.alias != 0) {
    out.open("Identification", {{"Value", EniText::decimal(slave.alias)}});
    out.number("Ado", 0x0012);
    out.close();
  }
  out.text("Physics", slave.physics);
  out.number("VendorId", slave.identity.vendor_id);
  out.number("ProductCode", slave.identity.product_code);
  out.number("RevisionNo", slave.identity.revision_no);
  out.number("SerialNo", slave.identity.serial_no);
  out.close();
}

}  // namespace

void write_master(EniText& out, const MasterConfig& master) {
  out.open("Master");
  out.open("Info");
  out.text("Name", master.name);
  out.bytes("Destination", master.destination_mac);
  out.bytes("Source", master.source_mac);
  out.text("EtherType", "a488");
  out.close();
  if (master.mailbox_state_count) {
    out.open("MailboxStates");
    out.number("StartAddr", kMailboxStateStart);
    out.number("Count", *master.mailbox_state_count);
    out.close();
  }
  if (master.eoe) {
    out.open("EoE");
    out.number("MaxPorts", kEoePorts);
    out.number("MaxFrames", kEoeFrames);
    out.number("MaxMACs", kEoeMacs);
    out.close();
  }
  write_init_cmds(out, master.init_cmds);
  out.close();
}

void write_slave(EniText& out, const SlaveConfig& slave, const std::vector<SlaveConfig>& all) {
  out.open("Slave");
  write_info(out, slave);
  write_process_data(out, slave);
  if (slave.mailbox) {
    write_mailbox(out, *slave.mailbox);
  }
  write_init_cmds(out, slave.init_cmds);
  if (slave.previous) {
    write_previous(out, *slave.previous, all);
  }
  if (slave.hot_connect) {
    write_hot_connect(out, *slave.hot_connect);
  }
  write_dc(out, slave.dc);
  out.close();
}

std::string write_eni(const NetworkConfig& config) {
  EniText out;
  out.open("EtherCATConfig", {{"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
                              {"xsi:noNamespaceSchemaLocation", "EtherCATConfig.xsd"},
                              {"Version", "1.3"}});
  out.open("Config");
  write_master(out, config.master);
  for (const auto& slave : config.slaves) {
    write_slave(out, slave, config.slaves);
  }
  for (const auto& task : config.cyclic) {
    write_cyclic(out, task);
  }
  write_process_image(out, config.image);
  out.close();
  out.close();
  return out.take();
}

Status save_eni(const NetworkConfig& config, const std::string& path) {
  return write_file_atomic(path, write_eni(config));
}

}  // namespace syncline::eni
