// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "eni/esi/esi_device.h"
#include "eni/esi/esi_words.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "reasons/because.h"

/// Slots and Modules of modular devices.
namespace syncline::eni {
namespace {

SlotIncrements read_increments(const Node& node) {
  return {.slot_pdo = node.number<std::uint16_t>("SlotPdoIncrement"),
          .slot_group_pdo = node.number<std::uint16_t>("SlotGroupPdoIncrement"),
          .slot_index = node.number<std::uint16_t>("SlotIndexIncrement"),
          .slot_group_index = node.number<std::uint16_t>("SlotGroupIndexIncrement")};
}

ModuleIdent read_ident(const Node& node) {
  return {.ident = node.number<std::uint32_t>(), .is_default = node.boolean("Default").value_or(false)};
}

ModuleClass read_class(const Node& node) {
  return {.name = node.required("Class").trimmed(),
          .vendor_id = node.child_number<std::uint32_t>("VendorId"),
          .display_name = node.localized("Name").trimmed()};
}

void read_instances(const Node& node, SlotDescription& slot) {
  slot.min_instances = node.number<std::uint16_t>("MinInstances").value_or(0);
  const auto most = node.number<std::uint16_t>("MaxInstances");
  if (!most) node.warn(because("MaxInstances is missing; taken for 1"));
  slot.max_instances = most.value_or(1);
  if (slot.min_instances > slot.max_instances) {
    node.fail(ErrorCode::kXmlBadValue,
              because("MinInstances {least} is more than MaxInstances {most}", slot.min_instances, slot.max_instances));
  }
}

SlotDescription read_slot(const Node& node) {
  SlotDescription slot;
  slot.name = node.localized("Name").trimmed();
  read_instances(node, slot);
  for (const Node& ident : node.children("ModuleIdent")) slot.modules.push_back(read_ident(ident));
  for (const Node& one : node.children("ModuleClass")) slot.classes.push_back(read_class(one));
  slot.slot_group = node.number<std::uint16_t>("SlotGroup");
  slot.increments = read_increments(node);
  slot.mdp_channel = node.number<int>("MdpChannel");
  slot.image = read_image(node);
  return slot;
}

ModulePdoGroup read_pdo_group(const Node& node) {
  return {.name = node.trimmed(),
          .alignment = node.number<std::uint16_t>("Alignment").value_or(0),
          .rx_pdo = node.number<std::uint16_t>("RxPdo"),
          .tx_pdo = node.number<std::uint16_t>("TxPdo")};
}

void read_type(const Node& type, ModuleDescription& module) {
  if (!type.has("ModuleIdent")) type.fail(ErrorCode::kXmlBadValue, because("the attribute ModuleIdent is missing"));
  module.type = type.trimmed();
  module.ident = type.number<std::uint32_t>("ModuleIdent").value_or(0);
  module.module_class = type.attribute("ModuleClass");
  module.pdo_group = type.number<int>("ModulePdoGroup");
}

ModuleDescription read_module(const Node& node, SideFiles* side_files) {
  ModuleDescription module;
  read_type(node.required("Type"), module);
  module.name = node.child("Name") ? node.localized("Name").trimmed() : module.type;
  module.names = read_texts(node, "Name");
  for (const Node& pdo : node.children("RxPdo")) module.rx_pdos.push_back(read_pdo(pdo));
  for (const Node& pdo : node.children("TxPdo")) module.tx_pdos.push_back(read_pdo(pdo));
  check_pdo_indices(node, module.rx_pdos, module.tx_pdos);
  if (const Node coe = node.child("Mailbox").child("CoE")) module.coe = read_coe(coe);
  auto profiles = read_profiles(node, side_files);
  module.profiles = std::move(profiles.profiles);
  module.dictionary = std::move(profiles.dictionary);
  module.enums = std::move(profiles.enums);
  module.dc_op_mode = node.child("DcOpModeName").trimmed();
  module.image = read_image(node);
  return module;
}

bool fits(const ModuleDescription& module, const SlotDescription& slot, std::uint32_t vendor_id) {
  const auto by_ident = [&](const ModuleIdent& allowed) { return allowed.ident == module.ident; };
  const auto by_class = [&](const ModuleClass& allowed) {
    return !module.module_class.empty() && allowed.name == module.module_class &&
           allowed.vendor_id.value_or(vendor_id) == vendor_id;
  };
  return std::ranges::any_of(slot.modules, by_ident) || std::ranges::any_of(slot.classes, by_class);
}

}  // namespace

SlotsDescription read_slots(const Node& node) {
  SlotsDescription slots;
  for (const Node& slot : node.children("Slot")) slots.slots.push_back(read_slot(slot));
  for (const Node& group : node.children("ModulePdoGroup")) slots.pdo_groups.push_back(read_pdo_group(group));
  slots.max_slot_count = node.number<std::uint16_t>("MaxSlotCount");
  slots.max_slot_group_count = node.number<std::uint16_t>("MaxSlotGroupCount");
  slots.increments = read_increments(node);
  slots.identify_by = node.attribute("IdentifyModuleBy") == "IdentityObjekt" ? ModuleIdentification::kIdentityObject
                                                                             : ModuleIdentification::kModuleIdent;
  slots.mdp_channel_count = node.number<std::uint16_t>("SlotMdpChannelCount");
  slots.download_ident_list = node.boolean("DownloadModuleIdentList").value_or(false);
  slots.download_transition = node.attribute("DownloadModuleListTransition");
  return slots;
}

std::vector<ModuleDescription> read_modules(const Node& modules, SideFiles* side_files, XmlPieces* pieces) {
  std::vector<ModuleDescription> read;
  for (const Node& stub : modules.children("Module")) {
    const Node node = pieces != nullptr ? pieces->whole(stub) : stub;
    if (!node) break;
    Reading part = node.reading().of_part();
    auto module = read_module(node.with(part), side_files);
    if (part.ok()) {
      read.push_back(std::move(module));
    } else {
      node.reading().warn(part.error()->line, part.error()->subject,
                          because("the module is left out: {error}", reason_of(*part.error())));
    }
  }
  return read;
}

std::vector<ModuleDescription> modules_for(const SlotsDescription& slots, std::uint32_t vendor_id,
                                           const std::vector<ModuleDescription>& modules) {
  std::vector<ModuleDescription> fitting;
  for (const ModuleDescription& module : modules) {
    const bool fits_one =
        std::ranges::any_of(slots.slots, [&](const SlotDescription& slot) { return fits(module, slot, vendor_id); });
    const bool is_known = std::ranges::find(fitting, module.ident, &ModuleDescription::ident) != fitting.end();
    if (fits_one && !is_known) fitting.push_back(module);
  }
  return fitting;
}

std::vector<DeviceGroup> read_groups(const Node& descriptions) {
  std::vector<DeviceGroup> groups;
  for (const Node& node : descriptions.child("Groups").children("Group")) {
    groups.push_back({.type = node.child("Type").trimmed(),
                      .name = node.localized("Name").trimmed(),
                      .names = read_texts(node, "Name"),
                      .sort_order = node.number<int>("SortOrder").value_or(0),
                      .parent = node.attribute("ParentGroup"),
                      .image = read_image(node)});
  }
  return groups;
}

}  // namespace syncline::eni
