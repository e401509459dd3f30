// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/esi_writer.h"

#include <algorithm>
#include <cstddef>

#include "config/device_description.h"
#include "config/object_description.h"
#include "eni/esi/esi_attributes.h"
#include "eni/esi/esi_check_words.h"
#include "eni/esi/esi_words.h"

namespace syncline::eni {
namespace {

void register_element(XmlWriter& xml, std::string_view name, const std::optional<std::uint16_t>& value) {
  if (value) xml.element(name, hex_dec(*value));
}

std::string_view fmmu_text(FmmuUse use) {
  switch (use) {
    case FmmuUse::kUnused:
      return "";
    case FmmuUse::kOutputs:
      return "Outputs";
    case FmmuUse::kInputs:
      return "Inputs";
    case FmmuUse::kMailboxState:
      return "MBoxState";
  }
  return "";
}

void write_check(XmlWriter& xml, std::string_view name, const std::optional<bool>& check) {
  if (check) xml.attribute(name, *check ? "EQ" : "NONE");
}

void write_references(XmlWriter& xml, std::string_view tag, const std::vector<DeviceReference>& references) {
  for (const DeviceReference& reference : references) {
    xml.open(tag);
    hex_attribute(xml, "ProductCode", reference.product_code);
    hex_attribute(xml, "RevisionNo", reference.revision_no);
    text_attribute(xml, "ProductRevision", reference.product_revision);
    xml.text(reference.type).close();
  }
}

void write_type(XmlWriter& xml, const DeviceDescription& device) {
  xml.open("Type")
      .attribute("ProductCode", hex_dec(device.identity.product_code, 8))
      .attribute("RevisionNo", hex_dec(device.identity.revision_no, 8));
  if (device.identity.serial_no != 0) xml.attribute("SerialNo", hex_dec(device.identity.serial_no, 8));
  write_check(xml, "CheckProductCode", device.check_product_code);
  if (const auto check = device.check_revision) {
    xml.attribute("CheckRevisionNo", std::ranges::find(kRevisionChecks, *check, &RevisionCheckWord::check)->text);
  }
  write_check(xml, "CheckSerialNo", device.check_serial_no);
  flag(xml, "UseLrdLwr", device.use_lrd_lwr);
  optional_attribute(xml, "ModulePdoGroup", device.module_pdo_group);
  flag(xml, "DownloadModuleList", device.download_module_list);
  xml.text(device.type).close();
  write_references(xml, "HideType", device.hides);
  write_references(xml, "AlternativeType", device.alternatives);
  write_references(xml, "SubDevice", device.sub_devices);
  write_texts(xml, "Name", device.name, device.names);
}

void write_state_machine(XmlWriter& xml, const DeviceDescription& device) {
  const auto& t = device.timeouts;
  xml.open("StateMachine").open("Timeout");
  xml.element("PreopTimeout", decimal(t.preop)).element("SafeopOpTimeout", decimal(t.safeop_op));
  xml.element("BackToInitTimeout", decimal(t.back_to_init)).element("BackToSafeopTimeout", decimal(t.back_to_safeop));
  xml.close();
  if (const auto& b = device.behavior; b != StartBehavior{}) {
    xml.open("Behavior");
    flag(xml, "StartToInit", b.to_init);
    flag(xml, "StartToPreop", b.to_preop);
    flag(xml, "StartToSafeop", b.to_safeop);
    flag(xml, "StartToSafeopNoSync", b.to_safeop_no_sync);
    xml.close();
  }
  xml.close();
}

void write_controller(XmlWriter& xml, const DeviceDescription& device) {
  if (!device.dpram_size && !device.sync_manager_count && !device.fmmu_count) return;
  xml.open("EtherCATController");
  optional_element(xml, "DpramSize", device.dpram_size);
  optional_element(xml, "SmCount", device.sync_manager_count);
  optional_element(xml, "FmmuCount", device.fmmu_count);
  xml.close();
}

void write_port(XmlWriter& xml, const PortDescription& port) {
  xml.open("Port").element("Type", port.type);
  text_element(xml, "Connector", port.connector);
  text_element(xml, "Label", port.label);
  optional_element(xml, "RxDelay", port.rx_delay);
  optional_element(xml, "TxDelay", port.tx_delay);
  xml.close();
}

void write_info(XmlWriter& xml, const DeviceDescription& device) {
  xml.open("Info");
  if (device.ebus_current_ma) {
    xml.open("Electrical").element("EBusCurrent", decimal(*device.ebus_current_ma)).close();
  }
  write_state_machine(xml, device);
  if (device.mailbox) {
    xml.open("Mailbox").open("Timeout");
    xml.element("RequestTimeout", decimal(device.mailbox->request_timeout_ms));
    xml.element("ResponseTimeout", decimal(device.mailbox->response_timeout_ms));
    xml.close().close();
  }
  write_controller(xml, device);
  for (const PortDescription& port : device.ports) write_port(xml, port);
  if (device.identification_ado) xml.element("IdentificationAdo", hex_dec(*device.identification_ado));
  if (device.identification_reg134) xml.element("IdentificationReg134", "true");
  xml.close();
}

void write_fmmus(XmlWriter& xml, const DeviceDescription& device) {
  for (std::size_t i = 0; i < device.fmmus.size(); ++i) {
    xml.open("Fmmu");
    if (i < device.fmmu_options.size()) {
      const FmmuOptions& options = device.fmmu_options[i];
      flag(xml, "OpOnly", options.op_only);
      optional_attribute(xml, "Sm", options.sync_manager);
      optional_attribute(xml, "Su", options.sync_unit);
    }
    xml.text(fmmu_text(device.fmmus[i])).close();
  }
}

void write_sync_unit(XmlWriter& xml, const SyncUnitDescription& unit) {
  xml.open("Su");
  flag(xml, "SeparateSu", unit.separate_su);
  flag(xml, "SeparateFrame", unit.separate_frame);
  flag(xml, "DependOnInputState", unit.depend_on_input_state);
  flag(xml, "FrameRepeatSupport", unit.frame_repeat_support);
  xml.text(unit.name).close();
}

void write_sync_manager(XmlWriter& xml, const SyncManagerDescription& manager) {
  xml.open("Sm");
  optional_attribute(xml, "MinSize", manager.min_size);
  optional_attribute(xml, "MaxSize", manager.max_size);
  optional_attribute(xml, "DefaultSize", manager.default_size);
  xml.attribute("StartAddress", hex_dec(manager.start_address));
  xml.attribute("ControlByte", hex_dec(manager.control_byte, 2));
  xml.attribute("Enable", manager.enable ? "1" : "0");
  flag(xml, "OneByteMode", manager.one_byte_mode);
  flag(xml, "Virtual", manager.is_virtual);
  optional_flag(xml, "Watchdog", manager.watchdog);
  flag(xml, "OpOnly", manager.op_only);
  xml.text(sync_manager_word(manager.type)).close();
}

void write_esc(XmlWriter& xml, const DeviceDescription& device) {
  if (!device.reg_0108 && !device.reg_0400 && !device.reg_0410 && !device.reg_0420) return;
  xml.open("ESC");
  register_element(xml, "Reg0108", device.reg_0108);
  register_element(xml, "Reg0400", device.reg_0400);
  register_element(xml, "Reg0410", device.reg_0410);
  register_element(xml, "Reg0420", device.reg_0420);
  xml.close();
}

void write_eeprom(XmlWriter& xml, const EepromDescription& eeprom) {
  xml.open("Eeprom");
  if (!eeprom.image.empty()) {  // stands for all the others
    xml.element("Data", hex_bytes(eeprom.image)).close();
    return;
  }
  flag(xml, "AssignToPdi", eeprom.assign_to_pdi);
  xml.element("ByteSize", decimal(eeprom.byte_size)).element("ConfigData", hex_bytes(eeprom.config_data));
  if (!eeprom.boot_strap.empty()) xml.element("BootStrap", hex_bytes(eeprom.boot_strap));
  for (const EepromCategory& category : eeprom.categories) {
    xml.open("Category").element("CatNo", decimal(category.number)).element("Data", hex_bytes(category.data)).close();
  }
  xml.close();
}

}  // namespace

void write_profile(XmlWriter& xml, const std::vector<ChannelProfile>& profiles,
                   const std::vector<ObjectDescription>& objects, const std::vector<EnumDescription>& enums) {
  if (profiles.empty() && objects.empty() && enums.empty()) return;
  xml.open("Profile");
  if (!profiles.empty()) xml.element("ChannelCount", decimal(std::ssize(profiles)));
  for (const ChannelProfile& profile : profiles) {
    xml.open("ChannelInfo").element("ProfileNo", decimal(profile.profile_no));
    if (profile.add_info != 0) xml.element("AddInfo", decimal(profile.add_info));
    xml.close();
  }
  write_dictionary(xml, objects, enums);
  xml.close();
}

void write_device(XmlWriter& xml, const DeviceDescription& device) {
  xml.open("Device");
  flag(xml, "Invisible", device.invisible);
  xml.attribute("Physics", device.physics);
  write_type(xml, device);
  write_info(xml, device);
  xml.element("GroupType", device.group_type);
  write_profile(xml, device.profiles, device.dictionary, device.enums);
  write_fmmus(xml, device);
  for (const auto& manager : device.sync_managers) write_sync_manager(xml, manager);
  for (const auto& unit : device.sync_units) write_sync_unit(xml, unit);
  for (const Pdo& pdo : device.rx_pdos) write_pdo(xml, "RxPdo", pdo);
  for (const Pdo& pdo : device.tx_pdos) write_pdo(xml, "TxPdo", pdo);
  if (device.mailbox) write_mailbox(xml, *device.mailbox);
  if (device.dc) write_dc(xml, *device.dc);
  if (device.slots) write_slots(xml, *device.slots);
  write_esc(xml, device);
  write_eeprom(xml, device.eeprom);
  write_image(xml, device.image);
  xml.close();
}

std::string write_esi(const DeviceDescription& device) {
  XmlWriter xml;
  xml.open("EtherCATInfo").open("Vendor").element("Id", hex_dec(device.identity.vendor_id, 8));
  xml.element("Name", device.vendor_name).close();
  xml.open("Descriptions").open("Groups");
  if (!device.group_name.empty()) {
    xml.open("Group").element("Type", device.group_type).element("Name", device.group_name).close();
  }
  xml.close().open("Devices");
  write_device(xml, device);
  xml.close();
  write_modules(xml, device.modules);
  return xml.take();
}

}  // namespace syncline::eni
