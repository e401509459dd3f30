// SPDX-License-Identifier: Apache-2.0
#include "config/module_description.h"
#include "eni/esi/esi_attributes.h"
#include "eni/esi/esi_words.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

void write_increments(XmlWriter& xml, const SlotIncrements& increments) {
  optional_attribute(xml, "SlotPdoIncrement", increments.slot_pdo);
  optional_attribute(xml, "SlotGroupPdoIncrement", increments.slot_group_pdo);
  optional_attribute(xml, "SlotIndexIncrement", increments.slot_index);
  optional_attribute(xml, "SlotGroupIndexIncrement", increments.slot_group_index);
}

void write_slot(XmlWriter& xml, const SlotDescription& slot) {
  xml.open("Slot");
  optional_attribute(xml, "SlotGroup", slot.slot_group);
  xml.attribute("MinInstances", decimal(slot.min_instances)).attribute("MaxInstances", decimal(slot.max_instances));
  write_increments(xml, slot.increments);
  optional_attribute(xml, "MdpChannel", slot.mdp_channel);
  text_element(xml, "Name", slot.name);
  for (const ModuleIdent& module : slot.modules) {
    xml.open("ModuleIdent");
    flag(xml, "Default", module.is_default);
    xml.text(hex_dec(module.ident, 8)).close();
  }
  for (const ModuleClass& one : slot.classes) {
    xml.open("ModuleClass").element("Class", one.name);
    if (one.vendor_id) xml.element("VendorId", hex_dec(*one.vendor_id, 8));
    text_element(xml, "Name", one.display_name);
    xml.close();
  }
  write_image(xml, slot.image);
  xml.close();
}

void write_module(XmlWriter& xml, const ModuleDescription& module) {
  xml.open("Module").open("Type").attribute("ModuleIdent", hex_dec(module.ident, 8));
  text_attribute(xml, "ModuleClass", module.module_class);
  optional_attribute(xml, "ModulePdoGroup", module.pdo_group);
  xml.text(module.type).close();
  write_texts(xml, "Name", module.name, module.names);
  for (const Pdo& pdo : module.rx_pdos) write_pdo(xml, "RxPdo", pdo);
  for (const Pdo& pdo : module.tx_pdos) write_pdo(xml, "TxPdo", pdo);
  if (module.coe) {
    xml.open("Mailbox");
    write_coe(xml, *module.coe);
    xml.close();
  }
  write_profile(xml, module.profiles, module.dictionary, module.enums);
  text_element(xml, "DcOpModeName", module.dc_op_mode);
  write_image(xml, module.image);
  xml.close();
}

}  // namespace

void write_slots(XmlWriter& xml, const SlotsDescription& slots) {
  xml.open("Slots");
  optional_attribute(xml, "MaxSlotCount", slots.max_slot_count);
  optional_attribute(xml, "MaxSlotGroupCount", slots.max_slot_group_count);
  write_increments(xml, slots.increments);
  if (slots.identify_by == ModuleIdentification::kIdentityObject) xml.attribute("IdentifyModuleBy", "IdentityObjekt");
  optional_attribute(xml, "SlotMdpChannelCount", slots.mdp_channel_count);
  flag(xml, "DownloadModuleIdentList", slots.download_ident_list);
  text_attribute(xml, "DownloadModuleListTransition", slots.download_transition);
  for (const SlotDescription& slot : slots.slots) write_slot(xml, slot);
  for (const ModulePdoGroup& group : slots.pdo_groups) {
    xml.open("ModulePdoGroup");
    if (group.alignment != 0) xml.attribute("Alignment", decimal(group.alignment));
    if (group.rx_pdo) xml.attribute("RxPdo", hex_dec(*group.rx_pdo));
    if (group.tx_pdo) xml.attribute("TxPdo", hex_dec(*group.tx_pdo));
    xml.text(group.name).close();
  }
  xml.close();
}

void write_modules(XmlWriter& xml, const std::vector<ModuleDescription>& modules) {
  if (modules.empty()) return;
  xml.open("Modules");
  for (const ModuleDescription& module : modules) write_module(xml, module);
  xml.close();
}

}  // namespace syncline::eni
