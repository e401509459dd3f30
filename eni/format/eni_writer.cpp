// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_writer.h"

#include <array>

#include "eni/format/eni_file.h"
#include "eni/format/eni_style.h"
#include "eni/format/eni_text.h"
#include "eni/xml/xml_text.h"
#include "protocol/registers.h"

namespace syncline::eni {
namespace {

void write_dc(EniText& out, const std::optional<SlaveDcConfig>& dc) {
  if (!dc && !out.style().dc_element_always) {
    return;
  }
  const bool potential = dc && dc->potential_reference_clock;
  const bool used = dc && (dc->assign_activate != 0 || dc->reference_clock || dc->cycle_time0 != 0 || !potential);
  out.open("DC");
  if (potential || out.style().dc_element_always) {
    out.boolean("PotentialReferenceClock", potential);
  }
  if (used) {
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
  out.open("PreviousPort", {{"Selected", out.flag(true)}});
  out.text("Port", std::string(1, static_cast<char>('A' + previous.port)));
  out.number("PhysAddr", all[previous.position].station_address);
  out.close();
}

void write_other_port(EniText& out, const PossiblePort& port) {
  if (port.port < 1 || port.port > 3) {
    return;
  }
  out.open("PreviousPort");
  if (port.device_id) {
    out.number("DeviceId", *port.device_id);
  }
  out.text("Port", std::string(1, static_cast<char>('A' + port.port)));
  if (port.station_address) {
    out.number("PhysAddr", *port.station_address);
  }
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
  if (slave.identification || slave.alias != 0) {
    const Identification by = slave.identification.value_or(Identification{reg::kStationAlias, slave.alias});
    out.open("Identification", {{"Value", EniText::decimal(by.value)}});
    out.number("Ado", by.ado);
    out.close();
  }
  out.text("Physics", slave.physics);
  out.number("VendorId", slave.identity.vendor_id);
  out.number("ProductCode", slave.identity.product_code);
  out.number("RevisionNo", slave.identity.revision_no);
  out.number("SerialNo", slave.identity.serial_no);
  if (!slave.product_revision.empty()) {
    out.text("ProductRevision", slave.product_revision);
  }
  out.close();
}

}  // namespace

void write_master(EniText& out, const MasterConfig& master) {
  out.open("Master");
  out.open("Info");
  out.text("Name", master.name);
  out.bytes("Destination", master.destination_mac);
  out.bytes("Source", master.source_mac);
  out.bytes("EtherType", std::array{static_cast<std::uint8_t>(master.ether_type & 0xFF),
                                    static_cast<std::uint8_t>(master.ether_type >> 8)});
  out.close();
  if (master.mailbox_state_count) {
    out.open("MailboxStates");
    out.number("StartAddr", master.mailbox_state_start);
    out.number("Count", *master.mailbox_state_count);
    out.close();
  }
  if (master.eoe) {
    out.open("EoE");
    out.number("MaxPorts", master.eoe_settings.max_ports);
    out.number("MaxFrames", master.eoe_settings.max_frames);
    out.number("MaxMACs", master.eoe_settings.max_macs);
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
  for (const auto& port : slave.other_ports) {
    write_other_port(out, port);
  }
  if (slave.hot_connect) {
    write_hot_connect(out, *slave.hot_connect);
  }
  write_dc(out, slave.dc);
  out.close();
}

EniStyle style_of(EniDialect dialect) {
  if (dialect == EniDialect::kTwinCat) {
    return {.words = true, .tabs = true, .declare_encoding = false, .dc_element_always = false};
  }
  return {};
}

std::string write_eni(const NetworkConfig& config, const EniStyle& style) {
  EniText out(style);
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

Status save_eni(const NetworkConfig& config, const std::string& path, const EniStyle& style) {
  return write_file_atomic(path, write_eni(config, style));
}

}  // namespace syncline::eni
