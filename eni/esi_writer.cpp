// SPDX-License-Identifier: Apache-2.0
#include "eni/esi_writer.h"

#include <fmt/format.h>

#include "eni/xml_number.h"

namespace syncline::eni {
namespace {

std::string decimal(std::int64_t value) { return fmt::format("{}", value); }

/// Attributes that the schema's default leaves out.
void flag(XmlWriter& xml, std::string_view name, bool value) {
  if (value) xml.attribute(name, "1");
}
void size_attribute(XmlWriter& xml, std::string_view name, const std::optional<std::uint16_t>& value) {
  if (value) xml.attribute(name, decimal(*value));
}
void register_element(XmlWriter& xml, std::string_view name, const std::optional<std::uint16_t>& value) {
  if (value) xml.element(name, hex_dec(*value));
}

std::string_view fmmu_text(FmmuUse use) {
  switch (use) {
    case FmmuUse::kUnused: return "";
    case FmmuUse::kOutputs: return "Outputs";
    case FmmuUse::kInputs: return "Inputs";
    case FmmuUse::kMailboxState: return "MBoxState";
  }
  return "";
}

std::string_view sync_manager_text(SyncManagerType type) {
  switch (type) {
    case SyncManagerType::kUnused: return "";
    case SyncManagerType::kMailboxOut: return "MBoxOut";
    case SyncManagerType::kMailboxIn: return "MBoxIn";
    case SyncManagerType::kOutputs: return "Outputs";
    case SyncManagerType::kInputs: return "Inputs";
  }
  return "";
}

void write_type(XmlWriter& xml, const DeviceDescription& device) {
  xml.open("Type")
      .attribute("ProductCode", hex_dec(device.identity.product_code, 8))
      .attribute("RevisionNo", hex_dec(device.identity.revision_no, 8));
  if (device.identity.serial_no != 0) xml.attribute("SerialNo", hex_dec(device.identity.serial_no, 8));
  if (device.check_revision_low_word) xml.attribute("CheckRevisionNo", "LW_EQ");
  flag(xml, "UseLrdLwr", device.use_lrd_lwr);
  xml.text(device.type).close();
  xml.open("Name").attribute("LcId", "1033").text(device.name).close();
}

void write_info(XmlWriter& xml, const DeviceDescription& device) {
  const auto& t = device.timeouts;
  xml.open("Info").open("StateMachine").open("Timeout");
  xml.element("PreopTimeout", decimal(t.preop)).element("SafeopOpTimeout", decimal(t.safeop_op));
  xml.element("BackToInitTimeout", decimal(t.back_to_init)).element("BackToSafeopTimeout", decimal(t.back_to_safeop));
  xml.close().close();
  if (device.mailbox) {
    xml.open("Mailbox").open("Timeout");
    xml.element("RequestTimeout", decimal(device.mailbox->request_timeout_ms));
    xml.element("ResponseTimeout", decimal(device.mailbox->response_timeout_ms));
    xml.close().close();
  }
  xml.close();
}

void write_profile(XmlWriter& xml, const DeviceDescription& device) {
  if (device.profiles.empty() && device.dictionary.empty()) return;
  xml.open("Profile");
  for (const ChannelProfile& profile : device.profiles) {
    xml.open("ChannelInfo").element("ProfileNo", decimal(profile.profile_no));
    if (profile.add_info != 0) xml.element("AddInfo", decimal(profile.add_info));
    xml.close();
  }
  write_dictionary(xml, device.dictionary);
  xml.close();
}

void write_sync_manager(XmlWriter& xml, const SyncManagerDescription& manager) {
  xml.open("Sm");
  size_attribute(xml, "MinSize", manager.min_size);
  size_attribute(xml, "MaxSize", manager.max_size);
  size_attribute(xml, "DefaultSize", manager.default_size);
  xml.attribute("StartAddress", hex_dec(manager.start_address));
  xml.attribute("ControlByte", hex_dec(manager.control_byte, 2));
  xml.attribute("Enable", manager.enable ? "1" : "0");
  flag(xml, "Virtual", manager.is_virtual);
  flag(xml, "OpOnly", manager.op_only);
  xml.text(sync_manager_text(manager.type)).close();
}

void write_coe(XmlWriter& xml, const CoeDescription& coe) {
  xml.open("CoE");
  flag(xml, "SdoInfo", coe.sdo_info);
  flag(xml, "PdoAssign", coe.pdo_assign);
  flag(xml, "PdoConfig", coe.pdo_config);
  flag(xml, "PdoUpload", coe.pdo_upload);
  flag(xml, "CompleteAccess", coe.complete_access);
  flag(xml, "SegmentedSdo", coe.segmented_sdo);
  for (const StartupCommand& command : coe.init_commands) {
    xml.open("InitCmd");
    flag(xml, "Fixed", command.fixed);
    flag(xml, "CompleteAccess", command.complete_access);
    write_init_cmd_content(xml, command);
    xml.close();
  }
  xml.close();
}

void write_mailbox(XmlWriter& xml, const MailboxDescription& mailbox) {
  xml.open("Mailbox");
  flag(xml, "DataLinkLayer", mailbox.data_link_layer);
  if (mailbox.aoe) xml.element("AoE", "");
  if (mailbox.eoe) xml.element("EoE", "");
  if (mailbox.coe) write_coe(xml, *mailbox.coe);
  if (mailbox.foe) xml.element("FoE", "");
  if (mailbox.soe) xml.element("SoE", "");
  if (mailbox.voe) xml.element("VoE", "");
  xml.close();
}

void write_time(XmlWriter& xml, std::string_view name, const DcTime& time) {
  if (time == DcTime{}) return;
  xml.open(name);
  if (time.factor) xml.attribute("Factor", decimal(*time.factor));
  flag(xml, "Input", time.input);
  xml.text(decimal(time.value_ns)).close();
}

void write_op_mode(XmlWriter& xml, const DcOpMode& mode) {
  xml.open("OpMode").element("Name", mode.name);
  if (!mode.description.empty()) xml.element("Desc", mode.description);
  xml.element("AssignActivate", hex_dec(mode.assign_activate));
  write_time(xml, "CycleTimeSync0", mode.cycle_time_sync0);
  write_time(xml, "ShiftTimeSync0", mode.shift_time_sync0);
  write_time(xml, "CycleTimeSync1", mode.cycle_time_sync1);
  write_time(xml, "ShiftTimeSync1", mode.shift_time_sync1);
  for (const OpModeSyncManager& manager : mode.sync_managers) {
    xml.open("Sm").attribute("No", decimal(manager.number));
    if (manager.sync_type) xml.element("SyncType", decimal(*manager.sync_type));
    for (const auto index : manager.pdos) xml.element("Pdo", hex_dec(index));
    xml.close();
  }
  xml.close();
}

void write_dc(XmlWriter& xml, const DcDescription& dc) {
  xml.open("Dc");
  flag(xml, "TimeLoopControlOnly", dc.time_loop_control_only);
  flag(xml, "UnknownFRMW", dc.unknown_frmw);
  flag(xml, "Unknown64Bit", dc.unknown_64bit);
  flag(xml, "PotentialReferenceClock", dc.potential_reference_clock);
  for (const DcOpMode& mode : dc.op_modes) write_op_mode(xml, mode);
  xml.close();
}

void write_esc(XmlWriter& xml, const DeviceDescription& device) {
  if (!device.reg_0400 && !device.reg_0410 && !device.reg_0420) return;
  xml.open("ESC");
  register_element(xml, "Reg0400", device.reg_0400);
  register_element(xml, "Reg0410", device.reg_0410);
  register_element(xml, "Reg0420", device.reg_0420);
  xml.close();
}

void write_eeprom(XmlWriter& xml, const EepromDescription& eeprom) {
  xml.open("Eeprom").element("ByteSize", decimal(eeprom.byte_size));
  xml.element("ConfigData", hex_bytes(eeprom.config_data));
  if (!eeprom.boot_strap.empty()) xml.element("BootStrap", hex_bytes(eeprom.boot_strap));
  xml.close();
}

}  // namespace

void write_pdo(XmlWriter& xml, std::string_view tag, const Pdo& pdo) {
  xml.open(tag);
  flag(xml, "Fixed", pdo.fixed);
  flag(xml, "Mandatory", pdo.mandatory);
  if (pdo.sync_manager) xml.attribute("Sm", decimal(*pdo.sync_manager));
  xml.element("Index", hex_dec(pdo.index)).element("Name", pdo.name);
  for (const auto index : pdo.exclude) xml.element("Exclude", hex_dec(index));
  for (const PdoEntry& entry : pdo.entries) {
    xml.open("Entry").element("Index", hex_dec(entry.index));
    if (entry.index != 0 || entry.sub_index != 0) xml.element("SubIndex", decimal(entry.sub_index));
    xml.element("BitLen", decimal(entry.bit_length));
    if (!entry.name.empty()) xml.element("Name", entry.name);
    if (!entry.data_type.empty()) xml.element("DataType", entry.data_type);
    xml.close();
  }
  xml.close();
}

void write_init_cmd_content(XmlWriter& xml, const StartupCommand& command) {
  for (const auto transition : command.transitions) xml.element("Transition", transition_name(transition));
  xml.element("Index", hex_dec(command.index)).element("SubIndex", decimal(command.sub_index));
  xml.element("Data", hex_bytes(command.data));
  if (!command.comment.empty()) xml.element("Comment", command.comment);
}

void write_device(XmlWriter& xml, const DeviceDescription& device) {
  xml.open("Device").attribute("Physics", device.physics);
  write_type(xml, device);
  write_info(xml, device);
  xml.element("GroupType", device.group_type);
  write_profile(xml, device);
  for (const FmmuUse use : device.fmmus) xml.element("Fmmu", fmmu_text(use));
  for (const auto& manager : device.sync_managers) write_sync_manager(xml, manager);
  for (const Pdo& pdo : device.rx_pdos) write_pdo(xml, "RxPdo", pdo);
  for (const Pdo& pdo : device.tx_pdos) write_pdo(xml, "TxPdo", pdo);
  if (device.mailbox) write_mailbox(xml, *device.mailbox);
  if (device.dc) write_dc(xml, *device.dc);
  write_esc(xml, device);
  write_eeprom(xml, device.eeprom);
  xml.close();
}

std::string write_esi(const DeviceDescription& device) {
  XmlWriter xml;
  xml.open("EtherCATInfo").open("Vendor").element("Id", hex_dec(device.identity.vendor_id, 8));
  xml.element("Name", device.vendor_name).close();
  xml.open("Descriptions").open("Groups").open("Group");
  xml.element("Type", device.group_type).element("Name", device.group_type).close().close();
  xml.open("Devices");
  write_device(xml, device);
  return xml.take();
}

}  // namespace syncline::eni
